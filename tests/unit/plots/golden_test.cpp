#include <cstdlib>
#include <fstream>

#include "plots/csv.h"
#include "plots/plot.h"
#include "plots/svg.h"
#include "support/read_file.h"
#include "unit/preview/exact.h"

namespace texbrdf::plots {
namespace {

/// A BRDF that is slow has few samples, so that the files are short; its numbers are exact.
Plot small_plot(View view) {
  Plot plot;
  plot.request.view = view;
  plot.request.theta_d = 30;
  plot.title = "a golden plot";
  plot.look.width = 420;
  plot.look.height = 300;
  for (const char* const equation : {"f = \\vec{1, 2, 4} * 0.125", "f = 0.375"}) {
    const preview::ExactModel model = preview::model_of_equations(equation);
    auto series = sample(model, plot.series.empty() ? "colour" : "grey", plot.request, {.steps = 60});
    EXPECT_TRUE(series) << series.error();
    if (series) plot.series.push_back(*std::move(series));
  }
  return plot;
}

void expect_file(const std::string& name, const std::string& content) {
  const std::string path = std::string(TEXBRDF_TEST_DATA "/plots/") + name;
  if (std::getenv("GOLDEN_UPDATE") != nullptr) {
    std::ofstream(path, std::ios::binary) << content;
  } else {
    EXPECT_EQ(content, test::read_file(path)) << name << " (GOLDEN_UPDATE=1 writes it again)";
  }
}

TEST(GoldenPlot, Polar) {
  expect_file("polar.svg", write_svg(draw(small_plot(View::Polar))));
  expect_file("polar.csv", write_csv(small_plot(View::Polar)));
}

TEST(GoldenPlot, OverTheHalfVector) {
  expect_file("theta-h.svg", write_svg(draw(small_plot(View::ThetaH))));
}

}  // namespace
}  // namespace texbrdf::plots

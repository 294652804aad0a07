#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/csv.h"
#include "plots/plot.h"
#include "plots/raster.h"
#include "plots/svg.h"
#include "unit/preview/exact.h"

namespace texbrdf::plots {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr View kViews[] = {
#define VIEW(name, word, description) View::name,
#include "plots/views.def"
#undef VIEW
};

Series curve_of(std::string label, std::vector<double> values) {
  Curve curve;
  for (const double value : values) {
    curve.angles.push_back(static_cast<double>(curve.angles.size()) * 10 - 20);
    curve.values.push_back(eval::Triple{value, value, value});
  }
  Series series;
  series.label = std::move(label);
  series.samples = std::move(curve);
  return series;
}

Plot plot_of(View view, const preview::ExactModel& model) {
  Plot plot;
  plot.request.view = view;
  auto series = sample(model, "", plot.request, {.steps = 3'000'000, .refinements = 3});
  EXPECT_TRUE(series) << series.error();
  if (series) plot.series.push_back(*std::move(series));
  return plot;
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The path of the first curve: it alone has this width.
std::string curve_path(const Plot& plot) {
  const std::string svg = write_svg(draw(plot));
  const std::size_t stroke = svg.rfind("stroke-width=\"1.6\"");
  const std::size_t start = svg.find(" d=\"", stroke) + 4;
  return stroke == std::string::npos ? "" : svg.substr(start, svg.find('"', start) - start);
}

TEST(Drawing, ACurveHasGapsWhereThereIsNoNumber) {
  Plot plot;
  plot.request.view = View::ThetaO;
  plot.series = {curve_of("", {1, 1, NAN, 1, kInfinity, 1, 1})};
  EXPECT_EQ(count_of(curve_path(plot), "M"), 3U);
  EXPECT_EQ(count_of(curve_path(plot), "nan"), 0U);
  EXPECT_EQ(notes_of(plot), (std::vector<std::string>{"no finite number at 2 of 7 samples (at 0°, 20°)"}));
}

TEST(Drawing, ALogarithmicAxisHasNoPlaceForZero) {
  Plot plot;
  plot.request.view = View::ThetaO;
  plot.look.scale = ScaleKind::Log;
  plot.series = {curve_of("a", {1, 0, 0.1, -1, 1})};
  EXPECT_EQ(count_of(curve_path(plot), "M"), 3U);
  EXPECT_EQ(notes_of(plot),
            (std::vector<std::string>{"a: values that are not above 0, not shown, at 2 of 5 samples (at −10°, 10°)"}));
}

TEST(Drawing, WhatIsBeyondTheMaximumIsCutOffAtTheFrame) {
  Plot plot;
  plot.request.view = View::ThetaO;
  plot.look.maximum = 1;
  plot.series = {curve_of("", {0, 2, 0})};
  // Up to the frame, and down from it, a quarter of the way from 0 to 2 and back.
  EXPECT_EQ(count_of(curve_path(plot), "M"), 2U);
  EXPECT_EQ(count_of(curve_path(plot), "L"), 2U);
}

TEST(Drawing, EveryViewIsAPictureOfItsSizeWhateverTheValues) {
  const char* const models[] = {"f = 0.3",
                                "f = 0",
                                "f = -0.3",
                                "f = 1 / (\\theta_o - \\theta_o)",
                                "f = (\\theta_o - \\theta_o) / (\\theta_o - \\theta_o)",
                                "f = 10^{300}",
                                "f = \\vec{0.1, 0.5, 0.9} * (\\theta_o - 1)",
                                "f = \\phi_o"};
  for (const View view : kViews) {
    for (const char* const equation : models) {
      for (const ScaleKind scale : {ScaleKind::Linear, ScaleKind::Log}) {
        Plot plot = plot_of(view, preview::model_of_equations(equation));
        plot.look.scale = scale;
        plot.look.width = 200;
        plot.look.height = 230;
        const Drawing drawing = draw(plot);
        const std::string svg = write_svg(drawing);
        EXPECT_EQ(count_of(svg, "\"nan") + count_of(svg, " nan") + count_of(svg, "inf "), 0U)
            << word_of(view) << equation;
        const render::ImageRgba8 image = rasterise(drawing);
        EXPECT_EQ(image.width, 200U);
        EXPECT_EQ(image.height, 230U);
        bool is_opaque = true;
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) is_opaque &= image.pixels[i] == 255;
        EXPECT_TRUE(is_opaque);
      }
    }
  }
}

TEST(Drawing, ALobeOfAConstantIsAHalfBall) {
  Plot plot = plot_of(View::Lobe, preview::model_of_equations("f = 1"));
  plot.look.elevation = 90;
  plot.look.maximum = 1;
  const render::ImageRgba8 image = rasterise(draw(plot));
  // From above: a disk of the surface's colour where the ground would be grey.
  const uint8_t* const middle = image.at(image.width / 2, image.height / 2 + 20);
  EXPECT_LT(middle[0], middle[2]);
}

TEST(Drawing, LabelsAreEscaped) {
  Plot plot;
  plot.request.view = View::Polar;
  plot.title = "a<b & \"c\"";
  plot.series = {curve_of("x_1", {1, 2}), curve_of("y<2", {2, 1})};
  const std::string svg = write_svg(draw(plot));
  EXPECT_EQ(count_of(svg, "a&lt;b &amp; &quot;c&quot;"), 2U);
  EXPECT_EQ(count_of(svg, ">x_1<"), 1U);
  EXPECT_EQ(count_of(svg, ">y&lt;2<"), 1U);
}

TEST(Csv, HasEachSampleInItsDigits) {
  Plot plot;
  plot.request.view = View::ThetaO;
  plot.series = {curve_of("a", {0.1, 1.0 / 3, NAN}), curve_of("b,\"c\"", {-kInfinity})};
  EXPECT_EQ(write_csv(plot),
            "series,theta_o,value\na,-20,0.1\na,-10,0.3333333333333333\na,0,nan\n\"b,\"\"c\"\"\",-20,-inf\n");
}

TEST(Csv, ChannelsAreColumnsAndWhatIsBelowTheHorizonIsEmpty) {
  Plot plot;
  plot.request.view = View::Slice;
  Series series;
  series.is_colour = true;
  series.samples =
      Grid{.rows = {10}, .columns = {20, 30}, .values = {eval::Triple{1, 2, 3}, std::nullopt}, .problem = ""};
  plot.series = {series};
  EXPECT_EQ(write_csv(plot), "series,theta_d,theta_h,red,green,blue\n,10,20,1,2,3\n,10,30,,,\n");
  plot.look.channels = Channels::Green;
  EXPECT_EQ(write_csv(plot), "series,theta_d,theta_h,green\n,10,20,2\n,10,30,\n");
}

}  // namespace
}  // namespace texbrdf::plots

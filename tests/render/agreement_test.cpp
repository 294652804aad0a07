#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "eval/evaluate.h"
#include "support.h"

// The same picture from the GPU and from the CPU.

namespace texbrdf {
namespace {

using eval::Geometry;
using eval::Triple;
using render::Picture;
using render::SphereView;

constexpr int kTolerance = 2;  // of 255

Picture cpu_picture(const ir::Program& program, const SphereView& view) {
  const auto model = preview::cpu_model(program);
  EXPECT_TRUE(model) << model.error();
  render::SphereCache cache;
  return preview::draw_on_cpu(*model, view, cache);
}

Picture gpu_picture(const ir::Program& program, const SphereView& view) {
  const auto model = preview::shader_model(program);
  EXPECT_TRUE(model) << model.error();
  render::RenderWorker worker(test::worker_options());
  return test::expect_picture(worker.draw(*model, view)).picture;
}

struct Difference {
  int largest = 0;        ///< of 255, over pixels that both find good or both find bad
  uint32_t disputed = 0;  ///< pixels that only one finds bad: where f changes its sign
};

bool is_marked(const Picture& picture, std::size_t pixel) {
  const uint8_t* shown = &picture.image.pixels[pixel * 4];
  return picture.bad_pixels.total() > 0 &&
         std::any_of(render::kBadPixelKinds.begin(), render::kBadPixelKinds.end(), [shown](render::BadPixel kind) {
           const auto& colour = render::bad_pixel_entry(kind).colour;
           return std::equal(colour.begin(), colour.end(), shown);
         });
}

Difference difference_of(const Picture& a, const Picture& b) {
  Difference difference;
  for (std::size_t pixel = 0; pixel < a.image.pixels.size() / 4; ++pixel) {
    if (is_marked(a, pixel) != is_marked(b, pixel)) {
      ++difference.disputed;
      continue;
    }
    for (std::size_t i = pixel * 4; i < pixel * 4 + 4; ++i) {
      difference.largest = std::max(difference.largest, std::abs(int{a.image.pixels[i]} - int{b.image.pixels[i]}));
    }
  }
  return difference;
}

class Model : public testing::TestWithParam<std::string> {};

TEST_P(Model, LooksTheSameOnBothDevices) {
  const ir::Program program = test::model_program(GetParam());
  for (const SphereView& view : {SphereView{}, SphereView{.size = 65, .theta = 80, .phi = -60, .exposure = 1}}) {
    const Picture cpu = cpu_picture(program, view);
    const Picture gpu = gpu_picture(program, view);
    ASSERT_EQ(cpu.image.pixels.size(), gpu.image.pixels.size());
    const Difference difference = difference_of(cpu, gpu);
    EXPECT_LE(difference.largest, kTolerance);
    EXPECT_LE(difference.disputed, cpu.bad_pixels.total() / 1000);
  }
}

Geometry geometry_of(const render::SphereGeometry& sphere, std::size_t i) {
  const auto vector = [i](const render::SphereGeometry::Vectors& v) {
    return Triple{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
  };
  const auto& [x, y, z] = sphere.light;
  return {{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)},
          {0, 0, 1},
          vector(sphere.normals),
          vector(sphere.tangents),
          vector(sphere.bitangents)};
}

/// What the double reference says of each lit point.
render::BadPixelCounts reference_counts(const ir::Program& program, const render::SphereGeometry& sphere) {
  const auto graph = ir::flatten(program);
  EXPECT_TRUE(graph) << graph.error();
  const eval::ReferenceEvaluator reference(*graph);
  std::vector<Triple> parameters;
  for (const ir::Parameter& parameter : program.parameters) parameters.push_back(parameter.value);
  render::BadPixelCounts counts;
  for (std::size_t i = 0; i < sphere.point_count(); ++i) {
    const Triple f = reference.evaluate(geometry_of(sphere, i), parameters);
    const auto any = [&f](auto&& is_bad) { return is_bad(f[0]) || is_bad(f[1]) || is_bad(f[2]); };
    if (any([](double x) { return std::isnan(x); })) {
      ++counts[render::BadPixel::NotANumber];
    } else if (any([](double x) { return std::isinf(x); })) {
      ++counts[render::BadPixel::Infinite];
    } else if (any([](double x) { return x < 0; })) {
      ++counts[render::BadPixel::Negative];
    }
  }
  return counts;
}

TEST_P(Model, HasTheBadPixelsOfTheReference) {
  const ir::Program program = test::model_program(GetParam());
  const SphereView view{.size = 64};
  const render::BadPixelCounts expected = reference_counts(program, render::make_sphere_geometry(view));
  const render::BadPixelCounts counts = cpu_picture(program, view).bad_pixels;
  for (const render::BadPixel kind : render::kBadPixelKinds) {
    EXPECT_NEAR(counts[kind], expected[kind], expected[kind] * 0.01) << bad_pixel_entry(kind).words;
  }
  // Of the twelve, one is negative far from the highlight, as it was published.
  EXPECT_EQ(counts.total() > 0, GetParam() == "edwards-2006") << describe(counts);
}

INSTANTIATE_TEST_SUITE_P(Agreement, Model, testing::ValuesIn(test::model_names()), test::test_name);

struct BadDocument {
  std::string name;
  std::string right_side;
  render::BadPixel kind;
};

void PrintTo(const BadDocument& document, std::ostream* stream) {
  *stream << document.right_side;
}

class Bad : public testing::TestWithParam<BadDocument> {};

TEST_P(Bad, IsMarkedAndCountedOnBothDevices) {
  const auto program = test::program_of(test::document_of(GetParam().right_side));
  ASSERT_TRUE(program) << program.error();
  const SphereView view{.size = 64};
  for (const Picture& picture : {cpu_picture(*program, view), gpu_picture(*program, view)}) {
    const uint32_t count = picture.bad_pixels[GetParam().kind];
    EXPECT_GT(count, 0U);
    EXPECT_EQ(picture.bad_pixels.total(), count) << describe(picture.bad_pixels);
    const auto colour = render::bad_pixel_entry(GetParam().kind).colour;
    uint32_t marked = 0;
    for (std::size_t i = 0; i < picture.image.pixels.size(); i += 4) {
      if (std::equal(colour.begin(), colour.end(), &picture.image.pixels[i])) ++marked;
    }
    EXPECT_EQ(marked, count);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Pixels, Bad,
    testing::Values(BadDocument{"negative", "-1", render::BadPixel::Negative},
                    BadDocument{"barely_negative", "-1e-30", render::BadPixel::Negative},
                    BadDocument{"one_channel", "\\vec{0.5, -0.1, 0.5}*1", render::BadPixel::Negative},
                    BadDocument{"infinite", "\\frac{1}{0}", render::BadPixel::Infinite},
                    BadDocument{"minus_infinite", "-\\frac{1}{0}", render::BadPixel::Infinite},
                    BadDocument{"zero_over_zero", "\\frac{0}{0}", render::BadPixel::NotANumber},
                    BadDocument{"logarithm", "\\ln(\\theta_i - 10)", render::BadPixel::NotANumber},
                    BadDocument{"root", "\\sqrt{\\cos\\theta_o - 2}", render::BadPixel::NotANumber},
                    BadDocument{"power", "(\\cos\\theta_i - 3)^{0.5}", render::BadPixel::NotANumber}),
    [](const auto& test) { return test.param.name; });

/// ln(θ_i − 0.5) is a number only where the light comes in slantingly, and negative until θ_i is 1.5.
TEST(Pixels, OnlyTheBadOnesAreMarked) {
  const auto program = test::program_of(test::document_of("\\ln(\\theta_i - 0.5) + 3"));
  ASSERT_TRUE(program) << program.error();
  const Picture cpu = cpu_picture(*program, {});
  const Picture gpu = gpu_picture(*program, {});
  const uint32_t lit = static_cast<uint32_t>(render::make_sphere_geometry({}).point_count());
  const uint32_t bad = cpu.bad_pixels[render::BadPixel::NotANumber];
  EXPECT_GT(bad, lit / 20);
  EXPECT_LT(bad, lit / 2);
  EXPECT_NEAR(gpu.bad_pixels[render::BadPixel::NotANumber], bad, lit * 0.002);
}

}  // namespace
}  // namespace texbrdf

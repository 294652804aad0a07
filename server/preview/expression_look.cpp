#include "preview/expression_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "render/png.h"
#include "render/tone_map.h"

namespace texbrdf::preview {
namespace {

using Vectors = render::SphereGeometry::Vectors;
using Direction = std::array<float, 3>;

constexpr std::size_t kSamples = 1024;
constexpr float kLengthTolerance = 1e-3F;

/// Of the additive recurrence that fills four dimensions evenly: powers of the root of x^5 = x + 1.
constexpr std::array kSteps{0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101};

double sequence(std::size_t index, std::size_t dimension) {
  double whole = 0;
  return std::modf(0.5 + kSteps[dimension] * static_cast<double>(index + 1), &whole);
}

/// Evenly over the hemisphere around the normal.
Direction direction(double cosine, double turn) {
  const double sine = std::sqrt(1 - cosine * cosine);
  const double phi = 2 * std::numbers::pi * turn;
  return {static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
          static_cast<float>(cosine)};
}

Direction viewer(std::size_t index, const Direction& light) {
  if (index % 4 == 0) return {-light[0], -light[1], light[2]};
  if (index % 4 == 1) return light;
  return direction(sequence(index, 2), sequence(index, 3));
}

Vectors repeated(const Direction& value, std::size_t count) {
  Vectors vectors;
  for (std::size_t c = 0; c < 3; ++c) vectors[c].assign(count, value[c]);
  return vectors;
}

void append(Vectors& vectors, const Direction& value) {
  for (std::size_t c = 0; c < 3; ++c) vectors[c].push_back(value[c]);
}

std::array<const float*, 3> pointers(const Vectors& vectors) {
  return {vectors[0].data(), vectors[1].data(), vectors[2].data()};
}

Vectors evaluate(const CpuModel& model, const eval::GeometryBatch& geometry) {
  Vectors values = repeated({}, geometry.count);
  model.evaluator.evaluate(geometry, model.parameters, {values[0].data(), values[1].data(), values[2].data()});
  return values;
}

/// The samples that are numbers, and whether some are not.
void find_extremes(const Vectors& values, uint32_t components, ExpressionLook& look) {
  for (uint32_t c = 0; c < components; ++c) {
    float least = std::numeric_limits<float>::infinity();
    float most = -least;
    bool has_number = false;
    for (const float value : values[c]) {
      look.has_nan |= std::isnan(value);
      if (std::isnan(value)) continue;
      has_number = true;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (!has_number) {
      look.least.clear();
      look.most.clear();
      return;
    }
    look.least.push_back(least);
    look.most.push_back(most);
  }
}

bool is_direction(const Vectors& values) {
  bool has_negative = false;
  bool has_unit_length = true;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    const Direction value{values[0][i], values[1][i], values[2][i]};
    has_negative |= std::ranges::any_of(value, [](float x) { return x < 0; });
    const float length = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    has_unit_length &= std::abs(length - 1) < kLengthTolerance;
  }
  return has_negative || has_unit_length;
}

}  // namespace

ExpressionSampler::ExpressionSampler()
    : normals_(repeated({0, 0, 1}, kSamples)),
      tangents_(repeated({1, 0, 0}, kSamples)),
      bitangents_(repeated({0, 1, 0}, kSamples)) {
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Direction light = direction(sequence(i, 0), sequence(i, 1));
    append(lights_, light);
    append(views_, viewer(i, light));
  }
}

std::optional<ExpressionLook> ExpressionSampler::look(const ir::Program& program) {
  const Result<CpuModel> model = cpu_model(program);
  if (!model) return std::nullopt;
  const std::size_t samples = model->depends_on_directions ? kSamples : 1;
  const Vectors values = evaluate(*model, {.count = samples,
                                           .light = pointers(lights_),
                                           .view = pointers(views_),
                                           .normal = pointers(normals_),
                                           .tangent = pointers(tangents_),
                                           .bitangent = pointers(bitangents_)});
  const uint32_t components = type_components(program.root().signature.result);
  ExpressionLook look;
  find_extremes(values, components, look);
  if (model->depends_on_directions) look.png = draw(*model, components == 3 && is_direction(values));
  return look;
}

std::vector<uint8_t> ExpressionSampler::draw(const CpuModel& model, bool as_directions) {
  const render::SphereView view{.size = kLookSize};
  const render::SphereGeometry& geometry = sphere_.geometry(view);
  const std::size_t count = geometry.point_count();
  const Vectors light = repeated(geometry.light, count);
  const Vectors viewer = repeated(geometry.view, count);
  const Vectors values = evaluate(model, {.count = count,
                                          .light = pointers(light),
                                          .view = pointers(viewer),
                                          .normal = pointers(geometry.normals),
                                          .tangent = pointers(geometry.tangents),
                                          .bitangent = pointers(geometry.bitangents)});
  const render::ShadedValues shaded{pointers(values), 1};
  const render::Picture picture =
      as_directions ? render::map_directions(geometry, shaded) : render::tone_map(geometry, view, shaded);
  return render::encode_png(picture.image, render::PngEffort::Fast);
}

}  // namespace texbrdf::preview

#include "preview/object_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "lighting/light_sample.h"
#include "render/gamma_table.h"

namespace texbrdf::preview {

namespace {

/// Geometries that a device is asked for at once.
constexpr std::size_t kBatchPoints = 65'536;

void append(render::GeometryTable& table, std::size_t first, const glm::dvec3& vector) {
  for (std::size_t c = 0; c < 3; ++c) table[first + c].push_back(static_cast<float>(vector[static_cast<int>(c)]));
}

}  // namespace

/// What waits for the evaluator, and what becomes of its values.
struct ObjectPicture::Batch {
  Batch(ObjectPicture& to, const TableEvaluator& evaluator, const std::function<bool()>& still_wanted)
      : picture(to), evaluate(evaluator), is_wanted(still_wanted) {}

  ObjectPicture& picture;
  const TableEvaluator& evaluate;
  const std::function<bool()>& is_wanted;
  render::GeometryTable table;
  std::vector<uint32_t> pixels;
  std::vector<glm::dvec3> weights;
  std::optional<render::RenderFault> fault;
  bool is_over = false;

  void add(uint32_t pixel, const objects::SurfaceFrame& frame, const glm::dvec3& light, const glm::dvec3& weight) {
    append(table, 0, light);
    append(table, 3, {0, 0, 1});
    append(table, 6, frame.normal);
    append(table, 9, frame.tangent);
    append(table, 12, frame.bitangent);
    pixels.push_back(pixel);
    weights.push_back(weight);
    if (pixels.size() == kBatchPoints) flush();
  }

  void flush() {
    if (pixels.empty() || is_over) return;
    const EvaluatedTable evaluated = evaluate(table);
    if (const auto* failed = std::get_if<render::RenderFault>(&evaluated)) {
      fault = *failed;
    } else {
      take(std::get<std::vector<float>>(evaluated));
    }
    is_over = fault || !is_wanted();
    for (std::vector<float>& list : table) list.clear();
    pixels.clear();
    weights.clear();
  }

  void take(const std::vector<float>& values) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::array<float, 3> value{values[i * 3], values[i * 3 + 1], values[i * 3 + 2]};
      if (const auto bad = render::find_bad(value)) {
        std::optional<render::BadPixel>& worst = picture.bad_[pixels[i]];
        worst = worst ? std::min(*worst, *bad) : *bad;
      } else {
        picture.sums_[pixels[i]] += glm::dvec3(value[0], value[1], value[2]) * weights[i];
      }
    }
  }
};

ObjectPicture::ObjectPicture(ObjectScene scene)
    : scene_(std::move(scene)),
      surface_(scene_.object, scene_.view),
      sums_(surface_.coverage().alpha.size(), glm::dvec3(0)),
      bad_(sums_.size()) {}

std::optional<render::RenderFault> ObjectPicture::add(uint32_t count, const TableEvaluator& evaluate,
                                                      const std::function<bool()>& is_wanted) {
  Batch batch(*this, evaluate, is_wanted);
  if (is_exact()) {
    if (samples_ == 0) add_directional(batch);
  } else {
    for (uint32_t i = 0; i < count; ++i) add_environment(batch, samples_ + i);
  }
  batch.flush();
  samples_ += count;
  return batch.fault;
}

/// All rays of each pixel.
void ObjectPicture::add_directional(Batch& batch) {
  const objects::Coverage& coverage = surface_.coverage();
  const auto [x, y, z] = light_direction(scene_.view);
  const glm::dvec3 light(x, y, z);
  for (uint32_t pixel = 0; pixel < coverage.alpha.size() && !batch.is_over; ++pixel) {
    const uint32_t count = coverage.begins[pixel + 1] - coverage.begins[pixel];
    for (uint32_t i = 0; i < count; ++i) {
      const objects::SurfaceFrame frame = surface_.frame(coverage.begins[pixel] + i);
      const double cosine = glm::dot(frame.normal, light);
      if (cosine > 0) batch.add(pixel, frame, light, glm::dvec3((scene_.view.times_cosine ? cosine : 1) / count));
    }
  }
}

/// One ray of each pixel, one after the other.
void ObjectPicture::add_environment(Batch& batch, uint32_t index) {
  const objects::Coverage& coverage = surface_.coverage();
  const glm::dmat3 to_world = glm::transpose(surface_.rotation());
  for (uint32_t pixel = 0; pixel < coverage.alpha.size() && !batch.is_over; ++pixel) {
    const uint32_t count = coverage.begins[pixel + 1] - coverage.begins[pixel];
    if (count == 0) continue;
    const lighting::SampleSequence sequence(pixel);
    // Each ray is drawn with both kinds of samples, which come in turn.
    const uint32_t ray = (index / 2 + sequence.shift() / 2) % count;
    const objects::SurfaceFrame frame = surface_.frame(coverage.begins[pixel] + ray);
    const lighting::LightSample sample =
        lighting::sample_light(*scene_.environment, to_world * frame.normal, sequence, index);
    if (sample.weight == glm::dvec3(0)) continue;
    batch.add(pixel, frame, surface_.rotation() * sample.direction, sample.weight);
  }
}

std::vector<glm::dvec3> ObjectPicture::radiance() const {
  const double scale = is_exact() || samples_ == 0 ? 1 : 1.0 / samples_;
  std::vector<glm::dvec3> pixels;
  pixels.reserve(sums_.size());
  for (const glm::dvec3& sum : sums_) pixels.push_back(sum * scale);
  return pixels;
}

render::Picture ObjectPicture::picture() const {
  const objects::Coverage& coverage = surface_.coverage();
  const render::GammaTable encode(scene_.view.gamma);
  const double scale = std::exp2(scene_.view.exposure) / (is_exact() || samples_ == 0 ? 1 : samples_);
  render::Picture picture{{coverage.size, coverage.size, std::vector<uint8_t>(sums_.size() * 4)}, {}};
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    uint8_t* pixel = &picture.image.pixels[i * 4];
    pixel[3] = coverage.alpha[i];
    if (bad_[i]) {
      ++picture.bad_pixels[*bad_[i]];
      std::ranges::copy(bad_pixel_entry(*bad_[i]).colour, pixel);
    } else {
      for (int c = 0; c < 3; ++c) pixel[c] = encode(static_cast<float>(sums_[i][c] * scale));
    }
  }
  return picture;
}

}  // namespace texbrdf::preview

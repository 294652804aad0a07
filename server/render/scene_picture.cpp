#include "render/scene_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/gamma_table.h"

namespace texbrdf::render {

namespace {

constexpr std::size_t kFirstStripPixels = 16'384;
constexpr double kShortMilliseconds = 150;
constexpr double kLongMilliseconds = 600;

std::optional<BadPixel> worse(std::optional<BadPixel> a, std::optional<BadPixel> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

uint8_t without_gamma(float value) {
  return static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

/// How high the next strip is.
class StripHeight {
 public:
  explicit StripHeight(uint32_t width)
      : most_(static_cast<uint32_t>(kMaxTilePixels / width)),
        height_(static_cast<uint32_t>(std::max<std::size_t>(kFirstStripPixels / width, 1))) {}

  uint32_t rows() const { return height_; }
  void learn(double milliseconds) {
    if (milliseconds < kShortMilliseconds) height_ = std::min(height_ * 2, most_);
    if (milliseconds > kLongMilliseconds) height_ = std::max(height_ / 2, 1U);
  }

 private:
  uint32_t most_;
  uint32_t height_;
};

}  // namespace

ScenePicture::ScenePicture(uint32_t width, uint32_t height)
    : width_(width),
      height_(height),
      sums_(std::size_t{width} * height * 3),
      counts_(std::size_t{width} * height),
      bad_(std::size_t{width} * height) {}

void ScenePicture::add(const SceneTile& tile, std::span<const float> values) {
  for (uint32_t row = 0; row < tile.height; ++row) {
    for (uint32_t column = 0; column < tile.width; ++column) {
      const float* from = &values[(std::size_t{row} * tile.width + column) * 3];
      const std::size_t pixel = std::size_t{tile.y + row} * width_ + tile.x + column;
      ++counts_[pixel];
      bad_[pixel] = worse(bad_[pixel], find_bad(std::array{from[0], from[1], from[2]}));
      for (std::size_t c = 0; c < 3; ++c) sums_[pixel * 3 + c] += from[c];
    }
  }
}

Picture ScenePicture::picture(SceneView view, const SceneDisplay& display) const {
  const GammaTable encode(display.gamma);
  const auto exposure = static_cast<float>(std::exp2(display.exposure));
  Picture picture{{width_, height_, std::vector<uint8_t>(counts_.size() * 4, 255)}, {}};
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    uint8_t* pixel = &picture.image.pixels[i * 4];
    if (bad_[i]) {
      ++picture.bad_pixels[*bad_[i]];
      std::ranges::copy(bad_pixel_entry(*bad_[i]).colour, pixel);
      continue;
    }
    const float part = 1 / static_cast<float>(std::max(counts_[i], 1U));
    for (std::size_t c = 0; c < 3; ++c) {
      const float mean = sums_[i * 3 + c] * part;
      pixel[c] = view == SceneView::Shaded ? encode(mean * exposure) : without_gamma(mean);
    }
  }
  return picture;
}

std::variant<ScenePicture, RenderFault> draw_scene(RenderWorker& worker, const SceneJob& job,
                                                   const SceneProgress& progress) {
  const SceneTile all{job.width, job.height, 0, 0, job.width, 1};
  if (const auto fault = find_fault(all)) return RenderFault{RenderFaultKind::Request, *fault};
  if (job.samples < 1 || job.samples > kMaxSamples) {
    return RenderFault{RenderFaultKind::Request,
                       fmt::format("a pixel has 1 to {} samples, not {}", kMaxSamples, job.samples)};
  }
  ScenePicture picture(job.width, job.height);
  StripHeight strip(job.width);
  SceneRequest request{job.source, job.state, job.look, all, {}};
  const uint64_t sample_pixels = uint64_t{job.width} * job.height;
  for (uint32_t sample = 0; sample < job.samples; ++sample) {
    request.sample = scene_sample(sample);
    for (uint32_t y = 0; y < job.height; y += request.tile.height) {
      request.tile.y = y;
      request.tile.height = std::min(strip.rows(), job.height - y);
      const auto answer = worker.trace(request);
      if (const auto* fault = std::get_if<RenderFault>(&answer)) return *fault;
      const auto& drawn = std::get<SceneAnswer>(answer);
      picture.add(request.tile, drawn.values);
      if (!drawn.compiled) strip.learn(drawn.milliseconds);
      const uint64_t done = sample * sample_pixels + uint64_t{y + request.tile.height} * job.width;
      if (!progress(done, sample_pixels * job.samples)) return picture;
    }
  }
  return picture;
}

}  // namespace texbrdf::render

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "render/bad_pixels.h"
#include "render/scene_view.h"
#include "render/tone_map.h"
#include "render/worker_client.h"

namespace texbrdf::render {

/// The mean of the samples of each pixel. A pixel with a bad sample is bad, whatever its others are.
class ScenePicture {
 public:
  ScenePicture(uint32_t width, uint32_t height);

  /// One sample of each pixel of the tile (SceneAnswer::values).
  void add(const SceneTile& tile, std::span<const float> values);
  /// As it is shown: gamma and exposure are for SceneView::Shaded. Opaque; pixels without a sample are black.
  Picture picture(SceneView view, const SceneDisplay& display) const;

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }

 private:
  uint32_t width_;
  uint32_t height_;
  std::vector<float> sums_;
  std::vector<uint32_t> counts_;
  std::vector<std::optional<BadPixel>> bad_;
};

/// All that a picture of a scene depends on.
struct SceneJob {
  std::string source;  ///< scene::SceneShader::source
  SceneState state;
  SceneLook look;
  uint32_t width = 512;
  uint32_t height = 512;
  uint32_t samples = 1;  ///< of each pixel, 1 to kMaxSamples
};

inline constexpr uint32_t kMaxSamples = 65'536;

/// Told after each answer of the worker; false: stop, the picture has what there is.
using SceneProgress = std::function<bool(uint64_t done_pixels, uint64_t all_pixels)>;

/// Draws in strips that are as high as the worker can do in some tenths of a second, sample by sample.
std::variant<ScenePicture, RenderFault> draw_scene(RenderWorker& worker, const SceneJob& job,
                                                   const SceneProgress& progress);

}  // namespace texbrdf::render

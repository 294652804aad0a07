#pragma once

#include <vector>

#include "render/gl.h"
#include "render/scene_view.h"
#include "source/result.h"

namespace texbrdf::render {

/// A float framebuffer for tiles of scenes.
class SceneTarget {
 public:
  explicit SceneTarget(const Gl& gl) : gl_(gl) {}
  ~SceneTarget();
  SceneTarget(const SceneTarget&) = delete;
  SceneTarget& operator=(const SceneTarget&) = delete;

  /// Makes it the target, at least as large as the tile.
  std::optional<Failure> bind(const SceneTile& tile);
  /// Red, green and blue of each pixel of the tile, from the top left.
  std::vector<float> read(const SceneTile& tile) const;

 private:
  const Gl& gl_;
  GLuint framebuffer_ = 0;
  GLuint renderbuffer_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
};

}  // namespace texbrdf::render

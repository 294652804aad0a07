#pragma once

#include <cstdint>
#include <string>

#include "render/gl.h"
#include "render/scene_tracer.h"
#include "render/scene_view.h"

namespace texbrdf::render {

/// Draws scenes into a window's framebuffer. While something moves, pictures have fewer pixels where all of them would
/// take too long, and are stretched.
class SceneScreen {
 public:
  /// Of the current context, which outlives the object, as the tracer does.
  SceneScreen(const Gl& gl, SceneTracer& tracer);
  ~SceneScreen();
  SceneScreen(const SceneScreen&) = delete;
  SceneScreen& operator=(const SceneScreen&) = delete;

  struct Drawn {
    bool is_whole = true;  ///< with all pixels
  };

  /// Waits until it is drawn. Fails as SceneTracer::draw.
  Result<Drawn> draw(const std::string& source, const SceneState& state, const SceneLook& look, uint32_t width,
                     uint32_t height, const SceneDisplay& display, bool is_moving);

 private:
  double part_of(uint32_t width, uint32_t height) const;
  void stretch(uint32_t from_width, uint32_t from_height, uint32_t width, uint32_t height) const;
  void resize(uint32_t width, uint32_t height);

  const Gl& gl_;
  SceneTracer& tracer_;
  GLuint framebuffer_ = 0;
  GLuint renderbuffer_ = 0;
  uint32_t width_ = 0;  ///< of the renderbuffer
  uint32_t height_ = 0;
  double milliseconds_a_pixel_ = 0;  ///< as the last picture took that compiled nothing
};

}  // namespace texbrdf::render

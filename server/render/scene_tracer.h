#pragma once

#include <memory>
#include <string>

#include "render/gl.h"
#include "render/glsl_check.h"
#include "render/scene_view.h"
#include "source/result.h"

namespace texbrdf::render {

/// Draws scenes by sphere tracing into whatever framebuffer is bound, in the context that is current: the render
/// worker's, a window's, or one of a program that has this library inside. Moving the camera, lights and dynamic
/// objects compiles nothing. One thread at a time; the context outlives the tracer.
class SceneTracer {
 public:
  /// Both outlive the tracer.
  static Result<SceneTracer> create(const Gl& gl, const GlslChecker& checker);
  SceneTracer(SceneTracer&&) noexcept;
  SceneTracer& operator=(SceneTracer&&) noexcept;
  ~SceneTracer();

  struct Drawn {
    bool compiled = false;  ///< false where the program was there
  };

  /// Makes the program ready without drawing. Fails with what glslang or the driver says against the source (of
  /// scene::SceneShader), in one line.
  Result<Drawn> prepare(const std::string& source, const SceneEffects& effects);

  /// Draws a tile at the framebuffer's lower left, its lowest row first. With a display the framebuffer gets the
  /// colours to be shown; without, what render/scene_picture.h takes: linear values that may be NaN or infinite, so it
  /// should have floats. None of the arguments has a fault. Leaves the viewport, vertex array and pipeline its own.
  Result<Drawn> draw(const std::string& source, const SceneState& state, const SceneLook& look, const SceneTile& tile,
                     const SceneSample& sample, const SceneDisplay* display = nullptr);

 private:
  struct State;
  explicit SceneTracer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf::render

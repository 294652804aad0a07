#pragma once

#include <string>
#include <string_view>

#include "render/scene_view.h"

namespace texbrdf::render {

/// The whole fragment shader that draws a scene: its source (scene::SceneShader) and the tracer around it. Numbers are
/// uniforms, so that nothing but another source or other effects make another text.
std::string scene_fragment_text(std::string_view source, const SceneEffects& effects);

}  // namespace texbrdf::render

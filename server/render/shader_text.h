#pragma once

#include <string>
#include <string_view>

namespace texbrdf::render {

/// Where a shader finds the geometry of its pixel.
enum class GeometrySource : uint8_t {
  Sphere,  ///< N from a texture, L and V the same everywhere, X and Y from N
  Table,   ///< all five from textures
};

/// A model's source made a whole fragment shader: the program and the names in it that are ours.
struct ShaderText {
  std::string fragment;
  std::string prefix;  ///< what our own names begin with; nothing in the source contains it
};

/// The names of the textures, in the order of their units, and of the two uniform directions, without the prefix.
inline constexpr std::string_view kTextureNames[] = {"normal", "light", "view", "tangent", "bitangent"};
inline constexpr std::string_view kLightName = "light";
inline constexpr std::string_view kViewName = "view";

ShaderText shader_text(std::string_view source, GeometrySource geometry);
/// Covers the picture with one triangle.
const char* vertex_shader_text();

}  // namespace texbrdf::render

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/object_table.h"

namespace texbrdf::scene {

// What is drawn: trees of objects with their materials, lights and a camera. Plain values: whoever builds one asks
// `find_fault` (check.h) before anything else is done with it.
// Right-handed coordinates, y is up. Colours are linear RGB. Angles are in radians unless a name says degrees.

using Triple = std::array<double, 3>;

template <typename Tag>
struct Id {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};
using NodeId = Id<struct NodeTag>;
using UserPrimitiveId = Id<struct UserPrimitiveTag>;
using ShaderId = Id<struct ShaderTag>;
using MaterialId = Id<struct MaterialTag>;

/// Where code of a user stands, for messages about it.
struct CodePlace {
  std::string file;         ///< "materials/blend.shader.json"
  std::string path;         ///< inside the file: "$.code"; empty where the file is nothing but code
  uint32_t first_line = 0;  ///< the line of the file, counted from 1, where the code begins and from which on its lines
                            ///< are those of the file; 0 where they are not
};

/// Scale first, then the rotation Rz · Ry · Rx (positive angles turn counter-clockwise seen from the positive axis),
/// then the translation; relative to the parent.
struct Transform {
  Triple position{0, 0, 0};
  Triple rotation{0, 0, 0};
  Triple scale{1, 1, 1};  ///< none is 0
  friend bool operator==(const Transform&, const Transform&) = default;
};

/// What a key does to a dynamic object while it is held, in units and radians a second, in the frame of its parent.
struct KeyBinding {
  std::string key;  ///< as GLFW calls it, without GLFW_KEY_: "I", "KP_ADD"
  Triple velocity{0, 0, 0};
  Triple turning{0, 0, 0};
};

/// The part of an object that can be moved without compiling anything.
struct Dynamic {
  std::string name;  ///< distinct in a scene, not empty
  std::vector<KeyBinding> keys;
};

struct Node {
  ObjectKind kind = ObjectKind::Union;
  UserPrimitiveId user_primitive;       ///< valid for ObjectKind::UserPrimitive only
  std::array<double, kMaxData> data{};  ///< all of them: see `with_defaults`
  Transform transform;
  MaterialId material;  ///< not valid: the one of the parent; at a root: a grey one
  std::optional<Dynamic> dynamic;
  std::vector<NodeId> children;  ///< united with a primitive; joined by an operation
};

/// A distance function of a user: `float name(vec3 p, Primitive3D primitive)`, reading primitive.data[0] … [7].
struct UserPrimitive {
  uint32_t id = kFirstUserPrimitive;
  std::string name;
  std::string code;  ///< GLSL, with the types and functions of Slang that user_code.h lists
  CodePlace place;
  /// A half size of a box around the origin that holds all of it, whatever its data; what is outside is cut off.
  /// Without one it is taken to be unbounded, and is always evaluated.
  std::optional<Triple> bounds;
  double lipschitz = 1;  ///< the largest slope of the function, 1 for a distance
};

enum class PropertyType : uint8_t { Int, Int2, Int3, Float, Float2, Float3 };

/// "float3"
std::string_view property_type_name(PropertyType type);
std::optional<PropertyType> find_property_type(std::string_view name);
std::vector<std::string_view> property_type_names();
std::size_t component_count(PropertyType type);
bool is_integer(PropertyType type);

/// Values of a material outside are clamped to the nearest inside, each component by itself.
struct PropertyRange {
  double least = 0;
  double greatest = 1;
};

struct Property {
  std::string name;  ///< an identifier of GLSL; a global of that name and type stands in the code
  PropertyType type = PropertyType::Float;
  std::optional<PropertyRange> range;
  Triple default_value{};  ///< for materials that do not say one
};

enum class ShaderKind : uint8_t {
  Shade,  ///< `float3 shade(FragmentProperties properties)`, the colour of a pixel
  Brdf,   ///< `vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)` as emit writes it, lit by the lights of the scene
};

struct Shader {
  std::string name;
  ShaderKind kind = ShaderKind::Shade;
  std::vector<Property> properties;
  std::string code;
  CodePlace place;
};

struct Material {
  std::string name;
  ShaderId shader;
  std::vector<Triple> values;  ///< one for each property of the shader, in their order; what is too many is 0
};

struct Camera {
  Triple position{2, 1.5, 3};
  Triple target{0, 0, 0};
  Triple up{0, 1, 0};
  double field_of_view = 45;  ///< degrees from the lower to the upper edge of the picture, more than 0, less than 180
};

/// The same from everywhere. A surface facing it gets the irradiance `colour`.
struct DirectionalLight {
  Triple direction{-0.5, -1, -0.7};  ///< where the light goes, of any length but 0
  Triple colour{3, 3, 3};
};

/// A surface at a distance d facing it gets the irradiance `colour` / d².
struct PointLight {
  Triple position{0, 3, 0};
  Triple colour{10, 10, 10};
};

using Light = std::variant<DirectionalLight, PointLight>;

struct Environment {
  Triple background{0.05, 0.06, 0.08};  ///< radiance where a ray meets nothing
  Triple ambient{0.2, 0.2, 0.2};        ///< radiance that comes to a surface from all sides
};

struct RenderSettings {
  uint32_t max_steps = 256;           ///< of a ray; 1 to 10 000
  double max_distance = 100;          ///< where a ray ends
  double surface_threshold = 0.0005;  ///< a ray that is nearer has met the surface
};

struct Scene {
  std::string name;
  std::vector<Node> nodes;    ///< children have smaller ids than their parents; each has at most one parent
  std::vector<NodeId> roots;  ///< united
  std::vector<UserPrimitive> user_primitives;
  std::vector<Shader> shaders;
  std::vector<Material> materials;
  Camera camera;
  std::vector<Light> lights{DirectionalLight{}};
  Environment environment;
  RenderSettings settings;

  const Node& node(NodeId id) const { return nodes[id.value]; }
};

inline constexpr std::size_t kMaxNodes = 4096;
inline constexpr std::size_t kMaxLights = 16;
inline constexpr std::size_t kMaxShaders = 256;
inline constexpr std::size_t kMaxMaterials = 1024;
inline constexpr std::size_t kMaxUserPrimitives = 256;
/// Their transforms are uniforms, of which drivers have few.
inline constexpr std::size_t kMaxDynamic = 64;
/// Levels of a tree.
inline constexpr std::size_t kMaxDepth = 64;

}  // namespace texbrdf::scene

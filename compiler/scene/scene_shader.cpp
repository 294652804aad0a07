#include "scene/scene_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/glsl_text.h"
#include "scene/tree_glsl.h"
#include "scene/tree_plan.h"
#include "scene/user_code.h"

namespace texbrdf::scene {
namespace {

using Cases = std::vector<std::pair<uint32_t, std::string>>;

constexpr std::string_view kTypes =
    "struct FragmentProperties { vec3 world_position; vec3 object_position; vec3 world_normal; vec3 ray_direction; float "
    "ray_distance; };\n"
    "struct Primitive3D { float data[8]; };\n";

constexpr std::string_view kSlangFunctions = R"(float scene_saturate(float x) { return clamp(x, 0.0, 1.0); }
vec2 scene_saturate(vec2 x) { return clamp(x, 0.0, 1.0); }
vec3 scene_saturate(vec3 x) { return clamp(x, 0.0, 1.0); }
vec4 scene_saturate(vec4 x) { return clamp(x, 0.0, 1.0); }
float scene_fmod(float x, float y) { return x - y * trunc(x / y); }
vec2 scene_fmod(vec2 x, vec2 y) { return x - y * trunc(x / y); }
vec3 scene_fmod(vec3 x, vec3 y) { return x - y * trunc(x / y); }
vec4 scene_fmod(vec4 x, vec4 y) { return x - y * trunc(x / y); }
)";

constexpr std::string_view kDefaultBrdf = "return vec3(0.7 / 3.14159265);";

/// Neighbours with the same text are one case.
void add_case(Cases& cases, uint32_t number, std::string text) {
  if (cases.empty() || cases.back().second != text) cases.emplace_back(number, std::move(text));
}

glm::dmat4x3 after(const glm::dmat4x3& outer, const Frame& inner) {
  glm::dmat4x3 result;
  const glm::dmat3 turn(outer[0], outer[1], outer[2]);
  for (int i = 0; i < 3; ++i) result[i] = turn * inner.to_parent[i];
  result[3] = turn * inner.position + outer[3];
  return result;
}

std::string value_text(const Property& property, Triple value) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < component_count(property.type); ++i) {
    if (property.range) value[i] = std::clamp(value[i], property.range->least, property.range->greatest);
    numbers.push_back(is_integer(property.type) ? fmt::format("{}", static_cast<int64_t>(value[i]))
                                                : float_text(value[i]));
  }
  if (numbers.size() == 1) return numbers.front();
  return fmt::format("{}vec{}({})", is_integer(property.type) ? "i" : "", numbers.size(), fmt::join(numbers, ", "));
}

class ShaderWriter {
 public:
  explicit ShaderWriter(const Scene& scene)
      : scene_(scene), plan_(plan_tree(scene)), materials_(material_of_nodes(scene)) {
    for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
      if (is_primitive(scene.nodes[i].kind)) leaves_.push_back(i);
    }
  }

  SceneShader run() {
    const std::size_t frames = scene_frames(scene_).size() / 4;
    if (frames > 0) text_ += fmt::format("uniform vec4 scene_frames[{}];\n", frames);
    text_ += kTypes;
    text_ += kSlangFunctions;
    write_primitives();
    write_shaders();
    text_ += "#line 1 0\n";
    text_ += tree_glsl(plan_, scene_, primitive_prefixes_);
    write_materials();
    write_origins();
    return {std::move(text_), std::move(places_), std::move(prefixes_)};
  }

 private:
  /// Gives the code a name space of its own and appends it.
  std::string write_code(const std::string& code, const CodePlace& place) {
    places_.push_back(place);
    std::string prefix = fmt::format("u{}x", places_.size());
    while (code.find(prefix) != std::string::npos) prefix += 'x';
    text_ +=
        fmt::format("#line {} {}\n{}\n", std::max(place.first_line, 1U), places_.size(), with_prefix(code, prefix));
    prefixes_.push_back(prefix);
    return prefix;
  }

  void write_primitives() {
    std::set<uint32_t> used;
    for (const Node& node : scene_.nodes) {
      if (node.kind == ObjectKind::UserPrimitive) used.insert(node.user_primitive.value);
    }
    primitive_prefixes_.resize(scene_.user_primitives.size());
    for (const uint32_t i : used)
      primitive_prefixes_[i] = write_code(scene_.user_primitives[i].code, scene_.user_primitives[i].place);
  }

  void write_shaders() {
    std::set<uint32_t> used;
    for (const uint32_t leaf : leaves_) {
      if (materials_[leaf] < scene_.materials.size()) used.insert(scene_.materials[materials_[leaf]].shader.value);
    }
    shader_prefixes_.resize(scene_.shaders.size());
    for (const uint32_t i : used) shader_prefixes_[i] = write_code(scene_.shaders[i].code, scene_.shaders[i].place);
  }

  /// The statements that give a material's values to its shader and call it.
  std::string call_of(const Material& material) const {
    const Shader& shader = scene_.shaders[material.shader.value];
    const std::string& prefix = shader_prefixes_[material.shader.value];
    std::string text;
    for (std::size_t i = 0; i < shader.properties.size(); ++i) {
      text += fmt::format("{}{} = {}; ", prefix, shader.properties[i].name,
                          value_text(shader.properties[i], material.values[i]));
    }
    const bool is_lit = shader.kind == ShaderKind::Brdf;
    return text + fmt::format("return {}{};", prefix, is_lit ? "brdf(L, V, N, X, Y)" : "shade(properties)");
  }

  void write_materials() {
    Cases numbers;
    for (const uint32_t leaf : leaves_) add_case(numbers, leaf, fmt::format("return {};", materials_[leaf]));
    text_ += fmt::format("int scene_material(int leaf) {{ {} }}\n", choice_text("leaf", numbers));
    const std::set<uint32_t> used(materials_.begin(), materials_.end());
    Cases lit;
    Cases brdfs{{0, std::string(kDefaultBrdf)}};
    Cases shades{{0, "return vec3(0.0);"}};
    for (const uint32_t i : used) {
      const bool is_default = i == scene_.materials.size();
      const bool is_lit = is_default || scene_.shaders[scene_.materials[i].shader.value].kind == ShaderKind::Brdf;
      add_case(lit, i, is_lit ? "return true;" : "return false;");
      add_case(is_lit ? brdfs : shades, i, is_default ? std::string(kDefaultBrdf) : call_of(scene_.materials[i]));
    }
    text_ += fmt::format("bool scene_is_lit(int material) {{ {} }}\n", choice_text("material", lit));
    text_ += fmt::format("vec3 scene_brdf(int material, vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {{ {} }}\n",
                         choice_text("material", brdfs));
    text_ += fmt::format("vec3 scene_shade(int material, FragmentProperties properties) {{ {} }}\n",
                         choice_text("material", shades));
  }

  /// Of leaves whose shader does not ask where they are, any place will do.
  void write_origins() {
    std::vector<bool> asks;
    for (const Shader& shader : scene_.shaders) asks.push_back(has_word(shader.code, "object_position"));
    origins_.assign(scene_.nodes.size(), {});
    frames_above_.assign(scene_.nodes.size(), std::nullopt);
    place_node(plan_.root, glm::dmat4x3(1), std::nullopt);
    Cases cases;
    for (const uint32_t leaf : leaves_) {
      const uint32_t material = materials_[leaf];
      const bool is_needed = material < scene_.materials.size() && asks[scene_.materials[material].shader.value];
      add_case(cases, leaf, fmt::format("return {};", is_needed ? origin_text(leaf) : "vec3(0.0)"));
    }
    if (std::ranges::any_of(frames_above_, [](const auto& frame) { return frame.has_value(); })) {
      text_ +=
          "vec3 frame_origin(int i, vec3 p) { vec4 q = vec4(p, 1.0); return vec3(dot(scene_frames[i + 4], q), "
          "dot(scene_frames[i + 5], q), dot(scene_frames[i + 6], q)); }\n";
    }
    text_ += fmt::format("vec3 scene_origin(int leaf) {{ {} }}\n", choice_text("leaf", cases));
  }

  std::string origin_text(uint32_t leaf) const {
    if (!frames_above_[leaf]) return vector_text(origins_[leaf]);
    return fmt::format("frame_origin({}, {})", *frames_above_[leaf] * kFramesStride, vector_text(origins_[leaf]));
  }

  /// `to_base` leads from the parent to the world or, below a dynamic object, to that one's own frame.
  void place_node(uint32_t index, const glm::dmat4x3& to_base, std::optional<uint32_t> dynamic) {
    const PlannedNode& node = plan_.nodes[index];
    const glm::dmat4x3 own = node.dynamic ? glm::dmat4x3(1) : after(to_base, node.frame);
    if (node.dynamic) dynamic = node.dynamic;
    if (is_primitive(node.kind)) {
      origins_[node.leaf] = own[3];
      frames_above_[node.leaf] = dynamic;
    }
    for (const uint32_t child : node.children) place_node(child, own, dynamic);
  }

  const Scene& scene_;
  TreePlan plan_;
  std::vector<uint32_t> materials_;  // by node
  std::vector<uint32_t> leaves_;     // nodes, rising
  std::string text_;
  std::vector<CodePlace> places_;
  std::vector<std::string> prefixes_;            // by place
  std::vector<std::string> primitive_prefixes_;  // of those that are used
  std::vector<std::string> shader_prefixes_;     // of those that are used
  std::vector<glm::dvec3> origins_;              // by node, in the world or the frame of the dynamic object
  std::vector<std::optional<uint32_t>> frames_above_;
};

void append_row(std::vector<float>& frames, const glm::dvec3& row, double last) {
  for (int i = 0; i < 3; ++i) frames.push_back(static_cast<float>(row[i]));
  frames.push_back(static_cast<float>(last));
}

}  // namespace

SceneShader make_scene_shader(const Scene& scene) {
  return ShaderWriter(scene).run();
}

std::string in_names_of_user(const SceneShader& shader, uint32_t source, std::string_view message) {
  std::string text(message);
  if (source == 0 || source > shader.prefixes.size()) return text;
  const std::string& prefix = shader.prefixes[source - 1];
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
    text.erase(at, prefix.size());
  return text;
}

std::vector<float> scene_frames(const Scene& scene) {
  std::vector<glm::dmat4x3> to_world(scene.nodes.size());
  const auto place = [&](NodeId id, const glm::dmat4x3& parent) {
    to_world[id.value] = after(parent, frame_of(scene.node(id).transform));
  };
  for (const NodeId root : scene.roots) place(root, glm::dmat4x3(1));
  for (std::size_t i = scene.nodes.size(); i-- > 0;) {
    for (const NodeId child : scene.nodes[i].children) place(child, to_world[i]);
  }
  std::vector<float> frames;
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].dynamic) continue;
    const Frame frame = frame_of(scene.nodes[i].transform);
    const glm::dvec3 moved = frame.to_local * -frame.position;
    const glm::dmat3 local_rows = glm::transpose(frame.to_local);
    for (int row = 0; row < 3; ++row) append_row(frames, local_rows[row], moved[row]);
    append_row(frames, {frame.factor, 0, 0}, 0);
    const glm::dmat4x3& world = to_world[i];
    for (int row = 0; row < 3; ++row) append_row(frames, {world[0][row], world[1][row], world[2][row]}, world[3][row]);
  }
  return frames;
}

}  // namespace texbrdf::scene

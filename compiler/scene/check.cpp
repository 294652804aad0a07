#include "scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "scene/user_code.h"

namespace texbrdf::scene {
namespace {

using Fault = std::optional<SceneFault>;

/// Half a turn is written with few digits.
constexpr double kWritten = 1e-6;

bool is_finite(const Triple& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

Fault data_fault(const Node& node, uint32_t index) {
  if (node.kind == ObjectKind::UserPrimitive) {
    for (uint32_t i = 0; i < kMaxData; ++i) {
      if (!std::isfinite(node.data[i])) return SceneFault{Part::NodeData, index, i, "the number must be finite"};
    }
    return std::nullopt;
  }
  const ObjectEntry& entry = object_entry(node.kind);
  for (uint32_t i = 0; i < entry.data_count; ++i) {
    const std::string_view rule = broken_rule(entry.data[i].domain, node.data[i]);
    if (!rule.empty()) {
      return SceneFault{Part::NodeData, index, i,
                        fmt::format("the {} must be {}, but is {}", entry.data[i].name, rule, node.data[i])};
    }
  }
  return std::nullopt;
}

/// What the numbers of an object must be to each other.
std::string_view broken_relation(const Node& node) {
  const auto& d = node.data;
  if (node.kind == ObjectKind::RoundedCuboid && d[3] > std::min({d[0], d[1], d[2]})) {
    return "the radius of the edges must not exceed half the width, height or depth";
  }
  if (node.kind == ObjectKind::RoundedBox && std::max({d[2], d[3], d[4], d[5]}) > std::min(d[0], d[1])) {
    return "the radii must not exceed half the width or height";
  }
  if (node.kind == ObjectKind::Plane && d[0] == 0 && d[1] == 0 && d[2] == 0) return "the normal must not be 0";
  if (node.kind == ObjectKind::Vesica && d[1] >= d[0]) return "the circles must meet: the radius exceeds the distance";
  if (node.kind == ObjectKind::Cross && d[1] > d[0]) return "an arm must be at least as long as half its width";
  if (node.kind == ObjectKind::CappedCone && d[1] == 0 && d[2] == 0) return "one of the radii must be more than 0";
  return {};
}

Fault node_fault(const Scene& scene, uint32_t index) {
  const Node& node = scene.nodes[index];
  const bool is_users = node.kind == ObjectKind::UserPrimitive;
  if (is_users && node.user_primitive.value >= scene.user_primitives.size()) {
    return SceneFault{Part::NodeKind, index, 0, "there is no such primitive"};
  }
  if (Fault fault = data_fault(node, index)) return fault;
  if (const std::string_view what = broken_relation(node); !what.empty()) {
    return SceneFault{Part::NodeData, index, 0, std::string(what)};
  }
  const Transform& transform = node.transform;
  if (!is_finite(transform.position) || !is_finite(transform.rotation) || !is_finite(transform.scale)) {
    return SceneFault{Part::NodeTransform, index, 0, "position, rotation and scale must be finite"};
  }
  if (std::count(transform.scale.begin(), transform.scale.end(), 0.0) > 0) {
    return SceneFault{Part::NodeTransform, index, 0, "no scale may be 0"};
  }
  if (node.material.valid() && node.material.value >= scene.materials.size()) {
    return SceneFault{Part::NodeMaterial, index, 0, "there is no such material"};
  }
  const bool is_operation = !is_users && object_entry(node.kind).id == 0;
  if (is_operation && node.children.empty()) {
    return SceneFault{Part::NodeChildren, index, 0, "an operation needs a child"};
  }
  return std::nullopt;
}

/// Children before parents, one parent each, trees that are not too high, 2D primitives where they belong.
Fault tree_fault(const Scene& scene) {
  std::vector<bool> has_parent(scene.nodes.size());
  std::vector<std::size_t> height(scene.nodes.size(), 1);
  std::vector<bool> is_flat(scene.nodes.size());
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const bool is_users = node.kind == ObjectKind::UserPrimitive;
    is_flat[i] = !is_users && object_entry(node.kind).object_class == ObjectClass::Primitive2d;
    for (const NodeId child : node.children) {
      if (child.value >= i || has_parent[child.value]) {
        return SceneFault{Part::NodeChildren, i, 0, "the objects are no tree"};
      }
      has_parent[child.value] = true;
      height[i] = std::max(height[i], height[child.value] + 1);
      if (is_flat[child.value]) is_flat[i] = true;
    }
    if (height[i] > kMaxDepth) {
      return SceneFault{Part::NodeChildren, i, 0, fmt::format("the tree has more than {} levels", kMaxDepth)};
    }
    if (node.kind == ObjectKind::Extrusion || node.kind == ObjectKind::Revolution) is_flat[i] = false;
  }
  for (const NodeId root : scene.roots) {
    if (root.value >= scene.nodes.size() || has_parent[root.value])
      return SceneFault{Part::Scene, 0, 0, "the objects are no tree"};
    has_parent[root.value] = true;
    if (is_flat[root.value]) {
      return SceneFault{Part::NodeKind, root.value, 0, "a 2D primitive stands below an extrusion or a revolution"};
    }
  }
  return std::nullopt;
}

Fault dynamic_fault(const Scene& scene) {
  std::set<std::string> names;
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const auto& dynamic = scene.nodes[i].dynamic;
    if (!dynamic) continue;
    if (dynamic->name.empty()) return SceneFault{Part::NodeDynamic, i, 0, "a dynamic object needs a name"};
    if (!names.insert(dynamic->name).second) {
      return SceneFault{Part::NodeDynamic, i, 0, fmt::format("two dynamic objects are called `{}`", dynamic->name)};
    }
  }
  if (names.size() > kMaxDynamic)
    return SceneFault{Part::Scene, 0, 0, fmt::format("more than {} dynamic objects", kMaxDynamic)};
  return std::nullopt;
}

Fault code_fault(const Scene& scene) {
  for (uint32_t i = 0; i < scene.user_primitives.size(); ++i) {
    if (auto fault = find_code_fault(scene.user_primitives[i]))
      return SceneFault{Part::UserPrimitive, i, fault->line, std::move(fault->message)};
  }
  for (uint32_t i = 0; i < scene.shaders.size(); ++i) {
    if (auto fault = find_code_fault(scene.shaders[i]))
      return SceneFault{Part::Shader, i, fault->line, std::move(fault->message)};
  }
  return std::nullopt;
}

Fault material_fault(const Scene& scene) {
  for (uint32_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    if (material.shader.value >= scene.shaders.size())
      return SceneFault{Part::Material, i, 0, "there is no such shader"};
    if (material.values.size() != scene.shaders[material.shader.value].properties.size()) {
      return SceneFault{Part::Material, i, 0, "each property of the shader needs one value"};
    }
    for (uint32_t item = 0; item < material.values.size(); ++item) {
      if (!is_finite(material.values[item]))
        return SceneFault{Part::MaterialValue, i, item, "the value must be finite"};
    }
  }
  return std::nullopt;
}

Fault view_fault(const Scene& scene) {
  const Camera& camera = scene.camera;
  const auto fault = [](Part part, std::string_view what) { return SceneFault{part, 0, 0, std::string(what)}; };
  if (!is_finite(camera.position) || !is_finite(camera.target) || !is_finite(camera.up))
    return fault(Part::Camera, "position, target and up must be finite");
  if (camera.position == camera.target) return fault(Part::Camera, "position and target must differ");
  if (camera.up == Triple{0, 0, 0}) return fault(Part::Camera, "up must not be 0");
  if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
    return fault(Part::Camera, "the field of view must be more than 0 and less than 180 degrees");
  const RenderSettings& settings = scene.settings;
  if (settings.max_steps < 1 || settings.max_steps > 10'000)
    return fault(Part::Settings, "the number of steps must be 1 to 10000");
  if (!(settings.max_distance > 0 && std::isfinite(settings.max_distance)))
    return fault(Part::Settings, "the longest distance must be more than 0");
  if (!(settings.surface_threshold > 0 && settings.surface_threshold < settings.max_distance))
    return fault(Part::Settings, "the threshold of surfaces must be more than 0 and less than the longest distance");
  if (!is_finite(scene.environment.background) || !is_finite(scene.environment.ambient))
    return fault(Part::Environment, "background and ambient light must be finite");
  return std::nullopt;
}

Fault size_fault(const Scene& scene) {
  const auto too_many = [](std::string_view what, std::size_t count, std::size_t limit) -> Fault {
    if (count <= limit) return std::nullopt;
    return SceneFault{Part::Scene, 0, 0, fmt::format("more than {} {}", limit, what)};
  };
  if (scene.roots.empty()) return SceneFault{Part::Scene, 0, 0, "the scene has no object"};
  if (Fault fault = too_many("objects", scene.nodes.size(), kMaxNodes)) return fault;
  if (Fault fault = too_many("lights", scene.lights.size(), kMaxLights)) return fault;
  if (Fault fault = too_many("shaders", scene.shaders.size(), kMaxShaders)) return fault;
  if (Fault fault = too_many("materials", scene.materials.size(), kMaxMaterials)) return fault;
  return too_many("primitives of users", scene.user_primitives.size(), kMaxUserPrimitives);
}

}  // namespace

std::string_view broken_rule(Domain domain, double value) {
  if (!std::isfinite(value)) return "finite";
  switch (domain) {
    case Domain::Any:
      return {};
    case Domain::Positive:
      return value > 0 ? "" : "more than 0";
    case Domain::NotNegative:
      return value >= 0 ? "" : "at least 0";
    case Domain::UpToQuarterTurn:
      return value > 0 && value < std::numbers::pi / 2 ? "" : "more than 0 and less than π/2";
    case Domain::UpToHalfTurn:
      return value > 0 && value <= std::numbers::pi + kWritten ? "" : "more than 0 and at most π";
    case Domain::Count:
      return value >= 0 && value <= kMaxCopies && value == std::floor(value) ? "" : "a whole number, 0 to 1000000";
    case Domain::Flag:
      return value == 0 || value == 1 ? "" : "0 or 1";
  }
  return {};
}

std::optional<SceneFault> find_fault(const Scene& scene) {
  if (Fault fault = size_fault(scene)) return fault;
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    if (Fault fault = node_fault(scene, i)) return fault;
  }
  if (Fault fault = tree_fault(scene)) return fault;
  if (Fault fault = dynamic_fault(scene)) return fault;
  if (Fault fault = code_fault(scene)) return fault;
  if (Fault fault = material_fault(scene)) return fault;
  return view_fault(scene);
}

}  // namespace texbrdf::scene

#include "scene/tree_plan.h"

namespace texbrdf::scene {
namespace {

std::vector<uint32_t> indices(const std::vector<NodeId>& ids) {
  std::vector<uint32_t> values;
  values.reserve(ids.size());
  for (const NodeId id : ids) values.push_back(id.value);
  return values;
}

}  // namespace

bool is_primitive(ObjectKind kind) {
  return kind == ObjectKind::UserPrimitive || object_entry(kind).id != 0;
}

TreePlan plan_tree(const Scene& scene) {
  TreePlan plan;
  uint32_t dynamic_count = 0;
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    PlannedNode planned{node.kind, node.data, node.user_primitive, i, indices(node.children), frame_of(node.transform),
                        {}};
    if (!is_primitive(node.kind)) planned.leaf = plan.nodes[planned.children.front()].leaf;
    if (node.dynamic) planned.dynamic = dynamic_count++;
    plan.nodes.push_back(std::move(planned));
  }
  PlannedNode root;
  root.children = indices(scene.roots);
  root.leaf = plan.nodes[root.children.front()].leaf;
  plan.root = static_cast<uint32_t>(plan.nodes.size());
  plan.nodes.push_back(std::move(root));
  return plan;
}

std::vector<uint32_t> material_of_nodes(const Scene& scene) {
  const auto default_material = static_cast<uint32_t>(scene.materials.size());
  std::vector<uint32_t> materials(scene.nodes.size(), default_material);
  const auto take = [&](NodeId id, uint32_t inherited) {
    const MaterialId own = scene.node(id).material;
    materials[id.value] = own.valid() ? own.value : inherited;
  };
  for (const NodeId root : scene.roots) take(root, default_material);
  for (std::size_t i = scene.nodes.size(); i-- > 0;) {
    for (const NodeId child : scene.nodes[i].children) take(child, materials[i]);
  }
  return materials;
}

}  // namespace texbrdf::scene

#include "ir/passes/passes.h"

namespace texbrdf::ir {

namespace {

std::vector<bool> find_live(const Graph& graph) {
  std::vector<bool> live(graph.size());
  for (const ValueId root : graph.roots) live[root.value] = true;
  for (uint32_t i = graph.size(); i-- > 0;) {
    if (!live[i]) continue;
    for (const ValueId operand : graph.operands({i})) live[operand.value] = true;
  }
  return live;
}

}  // namespace

Graph remove_dead_values(const Graph& graph) {
  const std::vector<bool> live = find_live(graph);
  Graph result;
  std::vector<ValueId> images(graph.size());
  std::vector<ValueId> operands;
  for (uint32_t i = 0; i < graph.size(); ++i) {
    if (!live[i]) continue;
    operands.clear();
    for (const ValueId operand : graph.operands({i})) operands.push_back(images[operand.value]);
    images[i] = result.copy(graph.at({i}), operands);
  }
  for (const ValueId root : graph.roots) result.roots.push_back(images[root.value]);
  return result;
}

}  // namespace texbrdf::ir

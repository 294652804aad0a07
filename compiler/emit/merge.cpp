#include "emit/merge.h"

#include <bit>

namespace texbrdf::emit {

std::vector<ir::ValueId> Merger::append(const ir::Graph& graph) {
  std::vector<ir::ValueId> images;
  images.reserve(graph.size());
  std::vector<ir::ValueId> operands;
  for (uint32_t i = 0; i < graph.size(); ++i) {
    operands.clear();
    for (ir::ValueId operand : graph.operands({i})) operands.push_back(images[operand.value]);
    images.push_back(image(graph.at({i}), operands));
  }
  for (ir::ValueId root : graph.roots) graph_.roots.push_back(images[root.value]);
  return images;
}

ir::ValueId Merger::image(const ir::Value& value, std::span<const ir::ValueId> operands) {
  std::vector<uint64_t> key{static_cast<uint64_t>(value.op), static_cast<uint64_t>(value.type), value.index,
                            std::bit_cast<uint64_t>(value.constant)};
  for (ir::ValueId operand : operands) key.push_back(operand.value);
  auto [entry, is_new] = known_.try_emplace(std::move(key));
  if (is_new) entry->second = graph_.copy(value, operands);
  return entry->second;
}

}  // namespace texbrdf::emit

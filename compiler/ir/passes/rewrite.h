#pragma once

#include <span>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::ir {

/// The walk that passes share: each value of `source` in order, with its operands' images, becomes what `replace`
/// says: `ValueId replace(Graph& result, ValueId id, std::span<const ValueId> operands)`.
template <typename Replace>
Graph rewrite(const Graph& source, Replace&& replace) {
  Graph result;
  std::vector<ValueId> images(source.size());
  std::vector<ValueId> operands;
  for (uint32_t i = 0; i < source.size(); ++i) {
    operands.clear();
    for (const ValueId operand : source.operands({i})) operands.push_back(images[operand.value]);
    images[i] = replace(result, ValueId{i}, std::span<const ValueId>(operands));
  }
  for (const ValueId root : source.roots) result.roots.push_back(images[root.value]);
  return result;
}

}  // namespace texbrdf::ir

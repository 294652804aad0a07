#include "ir/written_out.h"

#include <algorithm>
#include <vector>

namespace texbrdf::ir {

uint64_t written_out(const Program& program, uint64_t limit) {
  const uint64_t too_many = limit + 1;
  std::vector<uint64_t> sizes;
  uint64_t total = 0;
  for (const ProgramDefinition& definition : program.definitions) {
    uint64_t size = definition.graph.size();
    for (const Value& value : definition.graph.values()) {
      if (value.op == Op::Call) size = std::min(too_many, size + sizes[value.index]);
    }
    sizes.push_back(size);
    const bool is_root = &definition == &program.root();
    if (is_root || !definition.signature.is_function) total = std::min(too_many, total + size);
  }
  return total;
}

}  // namespace texbrdf::ir

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

struct CodeLensOptions {
  bool preview = false;
  bool uses = true;
};

/// A line above a definition that does or says something.
struct CodeLens {
  enum class Kind : uint8_t { Preview, Uses };
  Kind kind = Kind::Uses;
  Span span;              ///< the defined name
  std::string_view name;  ///< its canonical form; points into the snapshot's names
};

/// In document order: the preview at the root, the number of uses at every other definition in force. The number is
/// counted when it is shown.
std::vector<CodeLens> code_lenses(const Snapshot& snapshot, const CodeLensOptions& options);

/// How often the document uses what it defines under the name.
uint32_t count_uses(const Snapshot& snapshot, std::string_view name);

}  // namespace texbrdf::features

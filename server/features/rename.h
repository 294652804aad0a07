#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"
#include "features/text_edit.h"
#include "source/result.h"

namespace texbrdf::features {

struct RenameTarget {
  Span span;         ///< of the name at the place
  std::string text;  ///< as it is written there
};

/// The name at the offset, nothing where none stands, or why it cannot be renamed, in one line for a person.
Result<std::optional<RenameTarget>> renamable_at(const Snapshot& snapshot, uint32_t offset);

/// Gives the name at the offset, in all its spellings, a new one. Afterwards every other name means what it meant, and
/// every type and value is as before; where that cannot be, why, in one line for a person.
Result<std::vector<TextEdit>> rename(const Snapshot& snapshot, uint32_t offset, std::string_view new_name);

}  // namespace texbrdf::features

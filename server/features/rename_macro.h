#pragma once

#include "features/rename.h"

namespace texbrdf::features {

/// As `renamable_at` and `rename`, of macros.
Result<std::optional<RenameTarget>> renamable_macro_at(const Snapshot& snapshot, uint32_t offset);
Result<std::vector<TextEdit>> rename_macro(const Snapshot& snapshot, uint32_t offset, std::string_view new_name);

}  // namespace texbrdf::features

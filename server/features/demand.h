#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "features/caret.h"

namespace texbrdf::features {

/// The type that has to stand at a place, as far as what is in front of it says so.
///
/// `brackets` are those that are open in front of the token.
std::optional<Type> demanded_type(const Snapshot& snapshot, BlockId block, uint32_t token,
                                  std::span<const OpenBracket> brackets);

/// The definition in force that a call names, the first of those with an index, of a derivative the function; nothing
/// where the bracket belongs to no call, or of an unknown name.
std::optional<DefinitionId> callee(const Snapshot& snapshot, BlockId block, const OpenBracket& bracket);

/// What the text of a call calls, canonical; empty where the bracket belongs to no call.
std::string called_name(const Snapshot& snapshot, BlockId block, const OpenBracket& bracket);

}  // namespace texbrdf::features

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "semantics/types.h"

namespace texbrdf::features {

enum class CommandRole : uint8_t { Value, Operator, Decoration, Layout };

/// A command of the language as it is proposed, from completion_commands.def.
struct CompletionCommand {
  std::string_view spelling;
  std::string_view tail;  ///< what stands behind it; each `#` is a place to fill in
  CommandRole role;
  Type type;
  std::string_view documentation;
};

std::span<const CompletionCommand> completion_commands();

}  // namespace texbrdf::features

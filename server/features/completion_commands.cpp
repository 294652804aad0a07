#include "features/completion_commands.h"

#include <array>

namespace texbrdf::features {
namespace {

constexpr auto kCommands = std::to_array<CompletionCommand>({
#define COMPLETION_COMMAND(spelling, tail, role, type, documentation) \
  {spelling, tail, CommandRole::role, Type::type, documentation},
#include "features/completion_commands.def"
#undef COMPLETION_COMMAND
});

}  // namespace

std::span<const CompletionCommand> completion_commands() {
  return kCommands;
}

}  // namespace texbrdf::features

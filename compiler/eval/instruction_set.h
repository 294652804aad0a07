#pragma once

#include <array>
#include <string_view>

namespace texbrdf::eval {

/// The instruction sets that a batch can run on, chosen when the program runs.
enum class InstructionSet : unsigned char { Sse2, Avx2, Avx512 };

inline constexpr std::array kInstructionSets = {InstructionSet::Sse2, InstructionSet::Avx2, InstructionSet::Avx512};

std::string_view instruction_set_name(InstructionSet set);
bool has_instruction_set(InstructionSet set);
/// The best one that this machine has.
InstructionSet best_instruction_set();

}  // namespace texbrdf::eval

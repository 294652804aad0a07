#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "eval/tape.h"

namespace texbrdf::eval {

/// A value of one real or truth on its way into the tape, before it has a slot. Registers [0, kInputSlots) are inputs.
using Register = uint32_t;

/// A tape whose instructions name registers in place of slots. A register is written by one instruction, or by several
/// in a loop that it was first written before.
struct RegisterTape {
  /// Consecutive instructions that are repeated: [begin, end).
  struct Loop {
    uint32_t begin;
    uint32_t end;
    uint32_t parent;  ///< the loop around, or kNoLoop
  };
  static constexpr uint32_t kNoLoop = UINT32_MAX;

  /// One of the two lists.
  struct List {
    std::vector<Instruction> instructions;
    std::vector<uint32_t> loop_of;  ///< for each instruction, the innermost loop around it, or kNoLoop
    std::vector<Loop> loops;
  };

  List prologue;
  List body;
  std::vector<bool> is_uniform;  ///< by register: written by the prologue, or a constant or parameter
  std::vector<std::pair<Register, float>> constants;
  std::vector<TapeParameter> parameters;  ///< with registers as slots
  std::vector<Tape::Root> roots;          ///< with registers as slots
  std::array<bool, kInputSlots> uses_input{};

  uint32_t register_count() const { return static_cast<uint32_t>(is_uniform.size()); }
};

struct CodeEntry {
  uint32_t outputs;
  uint32_t inputs;
};
const CodeEntry& code_entry(Code code);

RegisterTape write_registers(const ir::Graph& graph);

/// Gives registers slots, the same one to registers that are not needed at the same time: few slots stay in the cache.
Tape allocate_slots(RegisterTape registers);

}  // namespace texbrdf::eval

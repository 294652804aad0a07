#include <algorithm>

#include "eval/tape_registers.h"

namespace texbrdf::eval {

namespace {

constexpr std::array kCodes = {
#define CODE(Name, outputs, inputs, meaning) CodeEntry{outputs, inputs},
#include "eval/tape_codes.def"
#undef CODE
};

constexpr uint32_t kNever = UINT32_MAX;

template <typename Action>
void for_each_input(const Instruction& instruction, Action action) {
  const CodeEntry& entry = code_entry(instruction.code);
  for (uint32_t i = 1; i <= entry.inputs; ++i) action(instruction.slots[i]);
}

template <typename Action>
void for_each_output(const Instruction& instruction, Action action) {
  const CodeEntry& entry = code_entry(instruction.code);
  if (entry.outputs > 0) action(instruction.slots[0]);
  for (uint32_t i = 1; i < entry.outputs; ++i) action(instruction.slots[entry.inputs + i]);
}

/// Slots of one kind. The one given back last is given out first: it is in the cache.
class SlotPool {
 public:
  uint32_t take() {
    if (free_.empty()) return count_++;
    const uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  void give_back(uint32_t slot) { free_.push_back(slot); }
  uint32_t count() const { return count_; }

 private:
  std::vector<uint32_t> free_;
  uint32_t count_ = 0;
};

/// A register lives from its first instruction to the last that reads it; where that is in a loop which does not hold
/// the first, to the end of the loop.
class Allocator {
 public:
  explicit Allocator(const RegisterTape& tape)
      : tape_(tape), slot_(tape.register_count(), kNever), lives_on_(tape.register_count(), false) {
    for (Register r = 0; r < kInputSlots; ++r) lives_on_[r] = true;
    for (const auto& [r, number] : tape.constants) keep(r);
    for (const TapeParameter& parameter : tape.parameters) keep(parameter.slot);
    for (const Tape::Root& root : tape.roots) {
      for (const Register r : root.slots) lives_on_[r] = true;
    }
    for (const Instruction& instruction : tape.body.instructions) {
      for_each_input(instruction, [this](Register r) {
        if (tape_.is_uniform[r]) lives_on_[r] = true;
      });
    }
    allocate(tape.prologue);
    allocate(tape.body);
  }

  uint32_t uniform_slots() const { return uniform_.count(); }
  uint32_t lane_slots() const { return lane_.count(); }
  uint32_t slot(Register r) const {
    if (r < kInputSlots) return r;
    return kInputSlots + slot_[r] + (tape_.is_uniform[r] ? 0 : uniform_.count());
  }

 private:
  SlotPool& pool(Register r) { return tape_.is_uniform[r] ? uniform_ : lane_; }

  void keep(Register r) {
    lives_on_[r] = true;
    slot_[r] = pool(r).take();
  }

  void allocate(const RegisterTape::List& list) {
    const std::vector<std::vector<Register>> dying = registers_by_death(list);
    for (uint32_t at = 0; at < list.instructions.size(); ++at) {
      const auto born_here = [this](Register r) {
        if (slot_[r] == kNever) slot_[r] = pool(r).take();
      };
      // A slot may be given to an output as soon as the inputs are read: instructions go lane by lane.
      for (const Register r : dying[at]) {
        if (slot_[r] != kNever) pool(r).give_back(slot_[r]);
      }
      for_each_output(list.instructions[at], born_here);
    }
  }

  std::vector<std::vector<Register>> registers_by_death(const RegisterTape::List& list) const {
    const auto count = static_cast<uint32_t>(list.instructions.size());
    std::vector<uint32_t> birth(tape_.register_count(), kNever);
    std::vector<uint32_t> death(tape_.register_count(), kNever);
    for (uint32_t at = 0; at < count; ++at) {
      for_each_input(list.instructions[at], [&](Register r) {
        if (!lives_on_[r]) death[r] = std::max(death[r] == kNever ? 0 : death[r], needed_until(list, at, birth[r]));
      });
      for_each_output(list.instructions[at], [&](Register r) { birth[r] = std::min(birth[r], at); });
    }
    std::vector<std::vector<Register>> result(count);
    for (Register r = 0; r < death.size(); ++r) {
      if (death[r] != kNever) result[death[r]].push_back(r);
    }
    return result;
  }

  /// The last instruction that may run before the read at `at` of what was written at `birth` runs again.
  static uint32_t needed_until(const RegisterTape::List& list, uint32_t at, uint32_t birth) {
    uint32_t until = at;
    for (uint32_t i = list.loop_of[at]; i != RegisterTape::kNoLoop; i = list.loops[i].parent) {
      const RegisterTape::Loop& loop = list.loops[i];
      if (birth >= loop.begin) break;
      until = loop.end - 1;
    }
    return until;
  }

  const RegisterTape& tape_;
  SlotPool uniform_;
  SlotPool lane_;
  std::vector<uint32_t> slot_;
  std::vector<bool> lives_on_;  ///< to the end: its slot is never given back
};

void rename(std::vector<Instruction>& instructions, const Allocator& allocator) {
  for (Instruction& instruction : instructions) {
    const CodeEntry& entry = code_entry(instruction.code);
    const uint32_t first = entry.outputs == 0 ? 1 : 0;
    const uint32_t last = entry.inputs + (entry.outputs > 1 ? entry.outputs - 1 : 0);
    for (uint32_t i = first; i <= last; ++i) instruction.slots[i] = allocator.slot(instruction.slots[i]);
  }
}

}  // namespace

const CodeEntry& code_entry(Code code) {
  return kCodes[static_cast<std::size_t>(code)];
}

Tape allocate_slots(RegisterTape registers) {
  const Allocator allocator(registers);
  Tape tape{.constants = {},
            .parameters = std::move(registers.parameters),
            .prologue = std::move(registers.prologue.instructions),
            .body = std::move(registers.body.instructions),
            .roots = std::move(registers.roots),
            .uses_input = registers.uses_input,
            .uniform_slots = allocator.uniform_slots(),
            .lane_slots = allocator.lane_slots()};
  rename(tape.prologue, allocator);
  rename(tape.body, allocator);
  for (const auto& [r, number] : registers.constants) tape.constants.push_back({allocator.slot(r), number});
  for (TapeParameter& parameter : tape.parameters) parameter.slot = allocator.slot(parameter.slot);
  for (Tape::Root& root : tape.roots) {
    for (uint32_t& slot : root.slots) slot = allocator.slot(slot);
  }
  return tape;
}

Tape build_tape(const ir::Graph& graph) {
  return allocate_slots(write_registers(graph));
}

}  // namespace texbrdf::eval

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "eval/kernels/kernel.h"
#include "ir/graph.h"

namespace texbrdf::eval {

/// The five inputs of a geometry by components come first among the slots.
inline constexpr uint32_t kInputSlots = 15;

/// A number that is written into its slot before the tape runs.
struct TapeConstant {
  uint32_t slot;
  float number;
};

struct TapeParameter {
  uint32_t slot;
  uint32_t parameter;
  uint32_t component;
};

/// A graph as instructions on slots. Slots in order: the inputs, `uniform_slots` that hold one number for all lanes,
/// `lane_slots` that hold one for each lane.
struct Tape {
  struct Root {
    std::array<uint32_t, 3> slots;
    uint32_t prologue_end;  ///< how many instructions of each list are enough for this root
    uint32_t body_end;
  };
  std::vector<TapeConstant> constants;
  std::vector<TapeParameter> parameters;
  std::vector<Instruction> prologue;  ///< what does not depend on the geometry: once for all batches
  std::vector<Instruction> body;      ///< once for each batch
  std::vector<Root> roots;
  std::array<bool, kInputSlots> uses_input{};
  uint32_t uniform_slots = 0;
  uint32_t lane_slots = 0;
};

/// `graph`: flattened; conventions that are made of others are expanded.
Tape build_tape(const ir::Graph& graph);

}  // namespace texbrdf::eval

#pragma once

// The interface between the tape and the kernels, which are compiled once for each instruction set. A kernel includes
// nothing but this and <immintrin.h>, and what is here has no inline functions: the linker keeps one copy of an inline
// function, and that copy must not be the one with AVX-512 instructions.

#include "eval/elementary_functions.h"

namespace texbrdf::eval {

enum class Code : unsigned char {
#define CODE(Name, outputs, inputs, meaning) Name,
#include "eval/tape_codes.def"
#undef CODE
};

inline constexpr unsigned kMaxSlots = 7;

/// One operation on all lanes.
struct Instruction {
  Code code;
  unsigned target;            ///< of a jump, an index into the instructions
  unsigned slots[kMaxSlots];  ///< in the order that tape_codes.def gives
};

/// As wide as a pointer: the compiler turns products of such into steps of pointers.
using Index = unsigned long;

/// Where the lanes of a value are.
struct Slot {
  float* data;
  Index stride;  ///< 1: a value each lane. 0: the same for all; `data` has kUniformLanes copies
};

/// As many as the widest vector register holds.
inline constexpr unsigned kUniformLanes = 16;

/// Runs the instructions for `lanes` lanes, a multiple of kUniformLanes; or for one register of lanes, all alike, where
/// `lanes` is 1.
using Kernel = void (*)(const Instruction* instructions, unsigned count, const Slot* slots, Index lanes,
                        const ElementaryFunctions& functions);

void run_sse2(const Instruction* instructions, unsigned count, const Slot* slots, Index lanes,
              const ElementaryFunctions& functions);
void run_avx2(const Instruction* instructions, unsigned count, const Slot* slots, Index lanes,
              const ElementaryFunctions& functions);
void run_avx512(const Instruction* instructions, unsigned count, const Slot* slots, Index lanes,
                const ElementaryFunctions& functions);

}  // namespace texbrdf::eval

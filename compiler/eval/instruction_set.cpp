#include "eval/instruction_set.h"

namespace texbrdf::eval {

std::string_view instruction_set_name(InstructionSet set) {
  switch (set) {
    case InstructionSet::Sse2:
      return "sse2";
    case InstructionSet::Avx2:
      return "avx2";
    case InstructionSet::Avx512:
      return "avx512";
  }
  return {};
}

bool has_instruction_set(InstructionSet set) {
  switch (set) {
    case InstructionSet::Sse2:
      return true;
    case InstructionSet::Avx2:
      // SLEEF's AVX2 functions use fused multiply-add too.
      return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    case InstructionSet::Avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
  }
  return false;
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::Avx512, InstructionSet::Avx2}) {
    if (has_instruction_set(set)) return set;
  }
  return InstructionSet::Sse2;
}

}  // namespace texbrdf::eval

#pragma once

// Included by the kernels: nothing here may be an inline function, see kernels/kernel.h.

namespace texbrdf::eval {

enum class InstructionSet : unsigned char;

/// A function on a whole vector register. Its true type, Vector(Vector) or Vector(Vector, Vector), exists only in the
/// kernel of its instruction set.
using VectorFunction = void (*)();

struct UnaryFunction {
  VectorFunction vector;  ///< nullptr: only the scalar one is there
  float (*scalar)(float);
};

struct BinaryFunction {
  VectorFunction vector;
  float (*scalar)(float, float);
};

/// The elementary functions in single precision, as elementary_functions.def lists them.
struct ElementaryFunctions {
#define UNARY(Name, name) UnaryFunction Name;
#define BINARY(Name, name) BinaryFunction Name;
#include "eval/elementary_functions.def"
#undef UNARY
#undef BINARY
};

/// SLEEF's functions (error at most 1.0 ulp) for the instruction set where libsleef.so.3 is installed, else those of
/// the C library. Loaded at the first call; safe from any thread.
const ElementaryFunctions& load_elementary_functions(InstructionSet set);
/// Those of the C library, one lane at a time.
const ElementaryFunctions& scalar_elementary_functions();

}  // namespace texbrdf::eval

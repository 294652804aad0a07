#pragma once

#include <string>

namespace texbrdf::emit {

/// The shortest decimal that reads back to the same single-precision number, without a dot where it is whole: `0.3`,
/// `256`, `1.1920929e-7`. Precondition: `number` is finite and fits single precision.
std::string plain_number(double number);
/// The same as a literal of GLSL, which needs a dot: `256.0`. Precondition: not negative.
std::string float_literal(double number);

}  // namespace texbrdf::emit

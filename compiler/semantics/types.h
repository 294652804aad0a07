#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf {

/// Types of expressions, from types.def. Error is the unknown type of what is in error: it goes with everything and
/// reports nothing.
/// Vector is a direction or position, Colour is linear RGB. Tuple is `(a, b, c)`, which is whichever its use demands.
enum class Type : uint8_t {
#define TYPE(name, symbol, components) name,
#include "semantics/types.def"
#undef TYPE
};

std::string_view type_symbol(Type type);
/// Numbers that a value of the type holds.
uint32_t type_components(Type type);
constexpr bool is_triple(Type type) {
  return type == Type::Vector || type == Type::Colour || type == Type::Tuple;
}

/// Whether a value of the type is one number, or three that operations take one by one beside numbers.
constexpr bool is_componentwise(Type type) {
  return type == Type::Real || type == Type::Colour || type == Type::Tuple;
}
/// Whether a value of the type can stand where the other is expected.
constexpr bool fits(Type type, Type expected) {
  return type == expected || (type == Type::Tuple && is_triple(expected)) ||
         (expected == Type::Tuple && is_triple(type));
}

/// What a name is: a plain definition has `is_function == false` and no parameters.
struct Signature {
  bool is_function = false;
  std::vector<Type> parameters;
  Type result = Type::Error;
  /// By position, one bit each: real parameters that the body takes component by component where they are colours. A
  /// call with a colour there is one call for each component, and gives a colour.
  uint64_t spreads = 0;

  bool is_spread(size_t position) const { return position < 64 && ((spreads >> position) & 1) != 0; }
  friend bool operator==(const Signature&, const Signature&) = default;
};

/// "ℝ³", or "ℝ × ℝ³ → ℝ³" for a function.
std::string signature_text(const Signature& signature);

/// True for a value, and for a function of two vectors.
bool has_brdf_parameters(const Signature& signature);

}  // namespace texbrdf

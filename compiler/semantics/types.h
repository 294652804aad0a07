#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf {

/// Types of expressions, from types.def. Error is the unknown type of what is in error: it goes with everything and
/// reports nothing.
/// Vector is a direction or position, Colour is linear RGB. Tuple is `(a, b, c)`, which is whichever its use demands.
enum class Type : uint8_t {
#define TYPE(name, symbol, rows, columns) name,
#include "semantics/types.def"
#undef TYPE
};

std::string_view type_symbol(Type type);
struct Shape {
  uint32_t rows = 0;
  uint32_t columns = 0;
  uint32_t entries() const { return rows * columns; }
  bool is_square() const { return rows == columns; }
  bool is_vector() const { return rows == 1 || columns == 1; }
  friend bool operator==(const Shape&, const Shape&) = default;
};
inline constexpr uint32_t kMaxRows = 4;  ///< and columns

Shape type_shape(Type type);
/// Of a triple the Tuple, which may be any. Nothing for a shape that no type has.
std::optional<Type> type_of_shape(Shape shape);
/// As a part of names in generated code: `vec3`, `rgb`.
std::string type_word(Type type);
/// Numbers that a value of the type holds.
uint32_t type_components(Type type);
/// ℝ², ℝ⁴, rows and matrices: values that are entries by themselves, before the linker is done.
constexpr bool is_aggregate(Type type) {
  return type > Type::Tuple;
}
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

/// What a name is: a plain definition has `is_function == false` and no parameters, unless it has implied ones.
struct Signature {
  bool is_function = false;
  std::vector<Type> parameters;
  Type result = Type::Error;
  /// By position, one bit each: real parameters that the body takes component by component where they are colours. A
  /// call with a colour there is one call for each component, and gives a colour.
  uint64_t spreads = 0;
  /// By position, one bit each: parameters on which no value depends, because the body hands them on to such ones at
  /// most.
  uint64_t unread = 0;
  /// By position, one bit each: parameters that neither their names nor what is made of them say the type of. A call
  /// with arguments of other types is one of an Instance.
  uint64_t open = 0;
  /// False where the body also uses what the expression of a parameter is made of: in `F(a - b) = (a - b) + b`, `b` is
  /// that of the document.
  bool is_callable = true;
  /// Of a plain definition that is a function of its implied parameters (implied_parameters.h).
  bool has_implied_parameters = false;

  bool is_unread(size_t position) const { return position < 64 && ((unread >> position) & 1) != 0; }
  bool is_spread(size_t position) const { return position < 64 && ((spreads >> position) & 1) != 0; }
  bool is_open(size_t position) const { return position < 64 && ((open >> position) & 1) != 0; }
  friend bool operator==(const Signature&, const Signature&) = default;
};

/// "ℝ³", or "ℝ × ℝ³ → ℝ³" for a function.
std::string signature_text(const Signature& signature);

/// True for a value, and for a function that is called with two vectors.
bool has_brdf_parameters(const Signature& signature);

}  // namespace texbrdf

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "semantics/types.h"
#include "syntax/token.h"

namespace texbrdf {

enum class Operator : uint8_t {
#define OPERATOR(name, needs) name,
#include "semantics/operators.def"
#undef OPERATOR
};

/// The binary operator that a token stands for; `\frac` is Divide.
std::optional<Operator> operator_of(TokenKind kind);
/// "`+` needs …": the rest of the sentence.
std::string_view operator_needs(Operator op);

/// The types that a value may still have, one bit each; empty: none fits.
class TypeSet {
 public:
  constexpr TypeSet() = default;
  constexpr TypeSet(Type type) : bits_(bit(type)) {}  // NOLINT(google-explicit-constructor)
  /// What a parameter may be while nothing is known of it.
  static constexpr TypeSet any_value() { return TypeSet(Type::Real) | TypeSet(Type::Vector); }
  static constexpr TypeSet all() { return from_bits(UINT8_MAX); }
  /// What elementary functions take.
  static constexpr TypeSet triples() { return TypeSet(Type::Vector) | Type::Colour | Type::Tuple; }
  static constexpr TypeSet componentwise() { return TypeSet(Type::Real) | Type::Colour | Type::Tuple; }
  /// What can stand where a value of the type is expected.
  static constexpr TypeSet fitting(Type expected) {
    TypeSet set = expected;
    for (Type type : {Type::Vector, Type::Colour, Type::Tuple}) {
      if (fits(type, expected)) set = set | type;
    }
    return set;
  }

  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool contains(Type type) const { return (bits_ & bit(type)) != 0; }
  friend constexpr TypeSet operator|(TypeSet a, TypeSet b) { return from_bits(a.bits_ | b.bits_); }
  friend constexpr TypeSet operator&(TypeSet a, TypeSet b) { return from_bits(a.bits_ & b.bits_); }
  friend constexpr bool operator==(TypeSet, TypeSet) = default;

 private:
  static constexpr uint8_t bit(Type type) { return static_cast<uint8_t>(1u << static_cast<unsigned>(type)); }
  static constexpr TypeSet from_bits(unsigned bits) {
    TypeSet set;
    set.bits_ = static_cast<uint8_t>(bits);
    return set;
  }
  uint8_t bits_ = 0;
};

/// The results that the rules allow for operands of these types. Error goes with everything and gives Error.
TypeSet results(Operator op, TypeSet left, TypeSet right);
/// The same for one type each; nothing where no rule fits. Beside an operand of type Error: what all rules for the
/// other give, Error where they differ or where there is none.
std::optional<Type> result(Operator op, Type left, Type right);

}  // namespace texbrdf

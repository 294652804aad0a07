#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "semantics/types.h"
#include "syntax/token.h"

namespace texbrdf {

enum class Operator : uint8_t {
#define OPERATOR(name, needs, matrix_needs) name,
#include "semantics/operators.def"
#undef OPERATOR
};

/// The binary operator that a token stands for; `\frac` is Divide.
std::optional<Operator> operator_of(TokenKind kind);
/// "`+` needs …": the rest of the sentence.
std::string_view operator_needs(Operator op);

/// The same where an operand is an aggregate.
std::string_view matrix_operator_needs(Operator op);

/// The types that a value may still have, one bit each; empty: none fits.
class TypeSet {
 public:
  constexpr TypeSet() = default;
  constexpr TypeSet(Type type) : bits_(bit(type)) {}  // NOLINT(google-explicit-constructor)
  /// What a parameter may be while nothing is known of it.
  static constexpr TypeSet any_value() { return TypeSet(Type::Real) | TypeSet(Type::Vector); }
  static constexpr TypeSet all() { return from_bits(UINT32_MAX); }
  /// What elementary functions take.
  static constexpr TypeSet triples() { return TypeSet(Type::Vector) | Type::Colour | Type::Tuple; }
  static constexpr TypeSet componentwise() { return TypeSet(Type::Real) | Type::Colour | Type::Tuple; }
  static constexpr TypeSet aggregates() { return from_bits(UINT32_MAX << (static_cast<unsigned>(Type::Tuple) + 1)); }
  /// What can stand where a value of the type is expected.
  static constexpr TypeSet fitting(Type expected) {
    TypeSet set = expected;
    for (Type type : {Type::Vector, Type::Colour, Type::Tuple}) {
      if (fits(type, expected)) set = set | type;
    }
    return set;
  }

  /// Every type by itself, Error included.
  static std::span<const Type> all_types();
  /// The type where there is only one, and that is an aggregate; else Error.
  Type only_aggregate() const;

  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool contains(Type type) const { return (bits_ & bit(type)) != 0; }
  /// The type that the value has, where only one is left.
  constexpr std::optional<Type> only() const {
    if (!std::has_single_bit(bits_)) return std::nullopt;
    return static_cast<Type>(std::countr_zero(bits_));
  }
  friend constexpr TypeSet operator|(TypeSet a, TypeSet b) { return from_bits(a.bits_ | b.bits_); }
  friend constexpr TypeSet operator&(TypeSet a, TypeSet b) { return from_bits(a.bits_ & b.bits_); }
  friend constexpr bool operator==(TypeSet, TypeSet) = default;

 private:
  static constexpr uint32_t bit(Type type) { return uint32_t{1} << static_cast<unsigned>(type); }
  static constexpr TypeSet from_bits(uint32_t bits) {
    TypeSet set;
    set.bits_ = bits;
    return set;
  }
  uint32_t bits_ = 0;
};

/// The results that the rules allow for operands of these types: operator_rules.def, and those of linear algebra in
/// matrix_rules.h. Error goes with everything and gives Error.
TypeSet results(Operator op, TypeSet left, TypeSet right);
/// The same for one type each; nothing where no rule fits. Beside an operand of type Error: what all rules for the
/// other give, Error where they differ or where there is none.
std::optional<Type> result(Operator op, Type left, Type right);

}  // namespace texbrdf

#pragma once

#include <array>
#include <cstdint>

#include "syntax/token.h"

namespace texbrdf {

/// What a token can do in an expression.
struct TokenRole {
  uint8_t infix = 0;      ///< binding power; 0 for what is no infix operator
  uint8_t right_min = 0;  ///< the weakest operator that its right operand may hold
  uint8_t prefix = 0;     ///< binding power; 0 for what is no prefix operator
  bool begins_operand = false;
};

inline constexpr uint8_t kJuxtapositionPower = 20;
inline constexpr uint8_t kPowerOperatorPower = 30;

enum class Associates : uint8_t { Left, Right };

constexpr std::array<TokenRole, 256> make_token_roles() {
  std::array<TokenRole, 256> roles{};
#define INFIX(token, power, associates)                       \
  roles[static_cast<size_t>(TokenKind::token)].infix = power; \
  roles[static_cast<size_t>(TokenKind::token)].right_min =    \
      Associates::associates == Associates::Left ? power + 1 : power;
#define PREFIX(token, power) roles[static_cast<size_t>(TokenKind::token)].prefix = power;
#include "syntax/operators.def"
#undef INFIX
#undef PREFIX
  for (const TokenKind kind : {TokenKind::Number,        TokenKind::Word,         TokenKind::Macro,
                               TokenKind::Text,          TokenKind::Vec,          TokenKind::Accent,
                               TokenKind::Function,      TokenKind::Extremum,     TokenKind::Frac,
                               TokenKind::Sqrt,          TokenKind::OpenParen,    TokenKind::OpenBrace,
                               TokenKind::OpenBracket,   TokenKind::OpenSet,      TokenKind::OpenAngle,
                               TokenKind::OpenCases,     TokenKind::OpenMatrix,   TokenKind::BigOperator,
                               TokenKind::Integral,      TokenKind::OpenIntegral, TokenKind::DifferentialFactor,
                               TokenKind::DerivativeFrac}) {
    roles[static_cast<size_t>(kind)].begins_operand = true;
  }
  return roles;
}

inline constexpr std::array<TokenRole, 256> kTokenRoles = make_token_roles();

constexpr TokenRole role_of(TokenKind kind) {
  return kTokenRoles[static_cast<size_t>(kind)];
}

}  // namespace texbrdf

#pragma once

#include <cstdint>
#include <string_view>

#include "syntax/parsed_block.h"

namespace texbrdf {

enum class Relation : uint8_t { None, Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual, Member };

/// From relations.def.
Relation read_relation(std::string_view spelling);
/// That which holds exactly where the other does not; None for Member.
Relation opposite(Relation relation);
/// That between the same operands the other way round.
Relation mirrored(Relation relation);

/// Both of a Junction's conditions must hold; else one.
bool is_conjunction(const ParsedBlock& block, NodeId junction);
/// The relation behind operand `index` of a Comparison.
uint32_t relation_token(const ParsedBlock& block, NodeId comparison, uint32_t index);

}  // namespace texbrdf

#include "syntax/relations.h"

#include <algorithm>
#include <iterator>

#include "syntax/remark.h"

namespace texbrdf {
namespace {

struct RelationSpelling {
  std::string_view spelling;
  Relation relation;
};

constexpr RelationSpelling kRelations[] = {
#define RELATION(spelling, relation) {spelling, Relation::relation},
#include "syntax/relations.def"
#undef RELATION
};

}  // namespace

Relation read_relation(std::string_view spelling) {
  const auto* const found = std::ranges::find(kRelations, spelling, &RelationSpelling::spelling);
  return found == std::end(kRelations) ? Relation::None : found->relation;
}

Relation opposite(Relation relation) {
  switch (relation) {
    case Relation::Less:
      return Relation::GreaterEqual;
    case Relation::LessEqual:
      return Relation::Greater;
    case Relation::Greater:
      return Relation::LessEqual;
    case Relation::GreaterEqual:
      return Relation::Less;
    case Relation::Equal:
      return Relation::NotEqual;
    case Relation::NotEqual:
      return Relation::Equal;
    case Relation::None:
    case Relation::Member:
      break;
  }
  return Relation::None;
}

Relation mirrored(Relation relation) {
  switch (relation) {
    case Relation::Less:
      return Relation::Greater;
    case Relation::LessEqual:
      return Relation::GreaterEqual;
    case Relation::Greater:
      return Relation::Less;
    case Relation::GreaterEqual:
      return Relation::LessEqual;
    case Relation::Equal:
    case Relation::NotEqual:
      return relation;
    case Relation::None:
    case Relation::Member:
      break;
  }
  return Relation::None;
}

bool is_conjunction(const ParsedBlock& block, NodeId junction) {
  const Token& token = block.tokens[block.tree.node(junction).token];
  if (token.kind == TokenKind::Remark) return read_remark(block.slice(token.span)) == RemarkKind::And;
  return token.kind != TokenKind::Or;
}

uint32_t relation_token(const ParsedBlock& block, NodeId comparison, uint32_t index) {
  uint32_t token = block.tree.node(block.tree.child(comparison, index)).end_token;
  while (block.tokens[token].kind != TokenKind::Relation && block.tokens[token].kind != TokenKind::Equals) ++token;
  return token;
}

}  // namespace texbrdf

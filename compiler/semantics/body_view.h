#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "semantics/check.h"

namespace texbrdf {

/// What the parts of the checker read of one definition.
struct DefinitionView {
  const ParsedBlock& block;
  const DefinitionSyntax& syntax;
  const BlockNames& names;
  const NameTable& table;
  const Facts& facts;

  const Node& node(NodeId id) const { return block.tree.node(id); }
  const Token& token(uint32_t index) const { return block.tokens[index]; }
  NameId name(NodeId id) const { return names.by_node[id.value]; }
  /// As it is written here, where that is short.
  std::string name_text(NodeId id) const { return shown_spelling(block.node_text(id), table.text(name(id))); }
  std::string defined_text() const { return name_text(syntax.name); }
  /// Place of a node in the definition's side tables.
  uint32_t slot(NodeId id) const { return id.value - syntax.first_node; }
  uint32_t slot_count() const { return syntax.node.value - syntax.first_node + 1; }
  /// The nodes of the right side, children before parents.
  uint32_t body_begin() const { return syntax.left.value + 1; }
  uint32_t body_end() const { return syntax.body.value + 1; }

  Location at(NodeId id) const { return Location{.file = {}, .block = {}, .span = block.span(id)}; }
  Location at_token(uint32_t index) const { return Location{.file = {}, .block = {}, .span = token(index).span}; }
  bool is_callee(NodeId name_node) const {
    const uint32_t behind = node(name_node).end_token;
    return block.opens_arguments(behind) || block.is_power_of_call(behind);
  }
  NodeId without_groups(NodeId id) const {
    while (node(id).kind == NodeKind::Group && node(id).child_count == 1) id = block.tree.child(id, 0);
    return id;
  }
};

/// `\prod`
inline bool is_product(const DefinitionView& view, NodeId id) {
  const Node& node = view.node(id);
  return node.kind == NodeKind::BigOperator && view.block.token_text(node.token) == "\\prod";
}

/// Tokens that are not read: the brace group behind an unknown command.
struct SkippedTokens {
  uint32_t begin, end;
};

/// A body whose names are known: what the types are formed from.
struct ResolvedBody {
  std::vector<Referent> referents;     ///< by slot
  std::vector<Type> leaves;            ///< by slot: of names that are no parameter; Error for all others
  std::vector<SkippedTokens> skipped;  ///< in order, apart from each other
  std::vector<BoundName> bound;        ///< as in CheckedDefinition
  std::vector<IndexedName> indexed;

  bool is_skipped(uint32_t first_token, uint32_t end_token) const {
    const auto behind = std::ranges::upper_bound(skipped, first_token, {}, &SkippedTokens::begin);
    return behind != skipped.begin() && end_token <= std::prev(behind)->end;
  }
  bool is_skipped(const Node& node) const { return is_skipped(node.first_token, node.end_token); }
};

inline Shape matrix_shape(const DefinitionView& view, NodeId matrix) {
  const std::span<const NodeId> rows = view.block.tree.children(matrix);
  return {static_cast<uint32_t>(rows.size()), view.node(rows[0]).child_count};
}

/// The Name that says that a power is a transposition.
inline NodeId transposition_sign(const DefinitionView& view, NodeId power) {
  NodeId sign = view.without_groups(view.block.tree.child(power, 1));
  if (view.node(sign).kind == NodeKind::Prefix) sign = view.block.tree.child(sign, 0);
  return sign;
}

/// What stands above the base can only be the sign of a transposition: it is no name of the document.
inline bool has_transposition_sign(const DefinitionView& view, const ResolvedBody& body, NodeId power) {
  return body.referents[view.slot(transposition_sign(view, power))].kind == Referent::Kind::Transposition;
}

}  // namespace texbrdf

#include "syntax/matrix_power.h"

#include <algorithm>

namespace texbrdf {
namespace {

/// `T` in `\mathsf{T}`, `\mathrm T`.
bool is_text_of_t(std::string_view text) {
  size_t letters = 1;
  while (letters < text.size() && text[letters] != ' ' && text[letters] != '{') ++letters;
  text.remove_prefix(std::min(letters, text.size()));
  size_t signs = 0;
  for (const char c : text) {
    if (c == ' ' || c == '{' || c == '}') continue;
    if (c != 'T') return false;
    ++signs;
  }
  return signs == 1;
}

NodeId without_groups(const SyntaxTree& tree, NodeId node) {
  while (tree.node(node).kind == NodeKind::Group) node = tree.child(node, 0);
  return node;
}

bool is_spelled_as_sign(const ParsedBlock& block, NodeId name) {
  const Node& node = block.tree.node(name);
  if (node.kind != NodeKind::Name || node.end_token != node.first_token + 1) return false;
  const std::string_view text = block.node_text(name);
  const TokenKind kind = block.tokens[node.first_token].kind;
  if (kind == TokenKind::Word) return text == "T";
  if (kind == TokenKind::Macro) return text == "\\top" || text == "\\intercal";
  return kind == TokenKind::Text && is_text_of_t(text);
}

}  // namespace

MatrixPower matrix_power(const ParsedBlock& block, NodeId node) {
  const SyntaxTree& tree = block.tree;
  const bool is_power = tree.node(node).kind == NodeKind::Infix && tree.node(node).child_count == 2 &&
                        block.tokens[tree.node(node).token].kind == TokenKind::Caret;
  if (!is_power) return MatrixPower::None;
  NodeId exponent = without_groups(tree, tree.child(node, 1));
  if (is_spelled_as_sign(block, exponent)) return MatrixPower::Transposed;
  const bool is_negative =
      tree.node(exponent).kind == NodeKind::Prefix && block.tokens[tree.node(exponent).token].kind == TokenKind::Minus;
  if (!is_negative) return MatrixPower::None;
  exponent = tree.child(exponent, 0);
  if (is_spelled_as_sign(block, exponent)) return MatrixPower::InverseTransposed;
  return block.node_text(exponent) == "1" ? MatrixPower::Inverse : MatrixPower::None;
}

/// The parent of a last child stands right behind it.
bool is_transposition_sign(const ParsedBlock& block, NodeId name) {
  if (!is_spelled_as_sign(block, name)) return false;
  NodeId exponent = name;
  for (uint32_t i = name.value + 1; i < block.tree.size(); ++i) {
    const Node& parent = block.tree.node(NodeId{i});
    if (parent.child_count == 0 || block.tree.child(NodeId{i}, parent.child_count - 1) != exponent) return false;
    if (parent.kind != NodeKind::Group && parent.kind != NodeKind::Prefix) break;
    exponent = NodeId{i};
  }
  const NodeId power{exponent.value + 1};
  return power.value < block.tree.size() && matrix_power(block, power) != MatrixPower::None;
}

}  // namespace texbrdf

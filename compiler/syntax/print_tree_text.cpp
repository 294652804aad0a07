#include "syntax/print_tree_text.h"

#include <vector>

#include "source/utf8.h"

namespace texbrdf {
namespace {

std::string range_text(Span span) {
  return std::to_string(span.begin) + "-" + std::to_string(span.end);
}

void print_node(std::string& out, const ParsedBlock& block, NodeId id, uint32_t depth) {
  const Node& node = block.tree.node(id);
  out.append(size_t{2} * depth, ' ');
  out += node_kind_name(node.kind);
  out += ' ' + range_text(block.span(id));
  const bool is_leaf = node.child_count == 0;
  const std::string_view text = is_leaf ? block.node_text(id) : block.token_text(node.token);
  if (!text.empty()) out += ' ' + printable(text);
  out += '\n';
  for (const NodeId child : block.tree.children(id)) print_node(out, block, child, depth + 1);
}

std::vector<NodeId> roots(const ParsedBlock& block) {
  std::vector<bool> is_child(block.tree.size());
  for (uint32_t i = 0; i < block.tree.size(); ++i) {
    for (const NodeId child : block.tree.children(NodeId{i})) is_child[child.value] = true;
  }
  std::vector<NodeId> found;
  for (uint32_t i = 0; i < block.tree.size(); ++i) {
    if (!is_child[i]) found.push_back(NodeId{i});
  }
  return found;
}

}  // namespace

std::string print_tokens_text(const ParsedBlock& block) {
  std::string out;
  for (const Token& token : block.tokens) {
    out += range_text(token.span) + ' ';
    out += token_kind_name(token.kind);
    if (!token.span.empty()) out += ' ' + printable(block.slice(token.span));
    out += '\n';
  }
  return out;
}

std::string print_tree_text(const ParsedBlock& block) {
  std::string out;
  for (const NodeId root : roots(block)) print_node(out, block, root, 0);
  return out;
}

}  // namespace texbrdf

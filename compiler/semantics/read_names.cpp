#include "semantics/bound_names.h"
#include "semantics/names.h"
#include "semantics/possible_names.h"

namespace texbrdf {
namespace {

bool is_word_or_command(TokenKind kind) {
  return kind == TokenKind::Word || kind == TokenKind::Macro;
}

// True for `n`, `\rho`, `x_1`, `\rho_d` and `D_{ab}`, written without spaces: they are their own canonical form, and
// most names are so. False says nothing.
bool is_surely_canonical(const ParsedBlock& block, const Node& node) {
  const std::span<const Token> tokens =
      std::span(block.tokens).subspan(node.first_token, node.end_token - node.first_token);
  if (!is_word_or_command(tokens[0].kind)) return false;
  for (size_t i = 1; i < tokens.size(); ++i) {
    if (tokens[i].span.begin != tokens[i - 1].span.end) return false;
  }
  const auto is_symbol = [&](size_t i) {
    if (tokens[i].kind == TokenKind::Word) return block.slice(tokens[i].span).find('\\') == std::string_view::npos;
    return tokens[i].kind == TokenKind::Macro || tokens[i].kind == TokenKind::Number;
  };
  const auto is_long = [&](size_t i) { return tokens[i].kind != TokenKind::Macro && tokens[i].span.size() > 1; };
  if (tokens.size() == 1) return true;
  if (tokens.size() == 3) return is_symbol(2) && !is_long(2);
  return tokens.size() == 5 && tokens[2].kind == TokenKind::OpenBrace && is_symbol(3) && is_long(3);
}

NameId read_node(const ParsedBlock& block, NodeId node, NameTable& table) {
  const std::string_view source = block.node_text(node);
  if (const NameId known = table.find(source); known.valid()) return known;
  if (is_surely_canonical(block, block.tree.node(node))) return table.intern(source);
  const std::string canonical = canonical_form(read_name(block, node));
  const NameId id = table.intern(canonical);
  if (canonical != source) table.add_spelling(source, id);
  return id;
}

// Nodes below a vector literal stand just before it in postorder.
void forget_elements(const SyntaxTree& tree, uint32_t literal, BlockNames& names) {
  const uint32_t first_token = tree.node(NodeId{literal}).first_token;
  for (uint32_t node = literal; node-- > 0;) {
    if (tree.node(NodeId{node}).first_token < first_token) break;
    names.by_node[node] = NameId{};
  }
}

}  // namespace

BlockNames read_names(const ParsedBlock& block, NameTable& table, std::pmr::memory_resource* memory) {
  BlockNames names{std::pmr::vector<NameId>(memory)};
  const std::span<const Node> nodes = block.tree.nodes();
  names.by_node.resize(nodes.size());
  for (uint32_t node = 0; node < nodes.size(); ++node) {
    if (nodes[node].kind == NodeKind::Name) names.by_node[node] = read_node(block, NodeId{node}, table);
    if (nodes[node].kind == NodeKind::VectorLiteral) forget_elements(block.tree, node, names);
  }
  read_possible_names(block, table, names);
  read_bound_names(block, table, names);
  return names;
}

}  // namespace texbrdf

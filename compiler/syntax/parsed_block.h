#pragma once

#include <algorithm>
#include <memory_resource>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "syntax/block_scanner.h"
#include "syntax/syntax_tree.h"

namespace texbrdf {

/// One definition of a block. Its nodes are [first_node, node], so side tables can be kept per definition.
struct DefinitionSyntax {
  NodeId node;  ///< the Definition node
  NodeId left;  ///< Name or Signature
  NodeId name;  ///< the Name node that is defined
  NodeId body;  ///< the right side; may be or contain Error nodes
  uint32_t first_node = 0;
  Span stretch;                   ///< of the block, up to the next statement: comments in it speak of this definition
  uint32_t first_diagnostic = 0;  ///< what was reported of it: [first_diagnostic, end_diagnostic) of the block's
  uint32_t end_diagnostic = 0;
  /// False where anything in the definition could not be read (it has Error nodes).
  bool readable = true;
};

/// All that a block's bytes say, without knowledge of any other block. Immutable; shared between snapshots.
struct ParsedBlock {
  /// Takes what it holds from `memory`, which has to outlive it.
  explicit ParsedBlock(std::pmr::memory_resource* memory)
      : text(memory), tokens(memory), comments(memory), factors(memory), tree(memory), definitions(memory) {}

  std::pmr::string text;            ///< the block's own bytes: BlockExtent::whole
  BlockExtent extent;               ///< as scanned; `whole` is then only good for its size
  std::pmr::vector<Token> tokens;   ///< of the content, closed by one End token
  std::pmr::vector<Span> comments;  ///< `%` to the end of the line, for `% range [0, 1]` and `% constant`
  /// The `(` behind names that open a factor and no arguments, as parse_block was told; in order.
  std::pmr::vector<uint32_t> factors;
  SyntaxTree tree;
  std::pmr::vector<DefinitionSyntax> definitions;
  std::vector<Diagnostic> diagnostics;  ///< by definition, then what concerns none; their Location::block is not set
                                        ///< yet (0); spans are relative

  std::string_view slice(Span span) const { return std::string_view(text).substr(span.begin, span.size()); }
  std::string_view token_text(uint32_t token) const { return slice(tokens[token].span); }
  /// From the first byte of the node's first token to the last byte of its last.
  Span span(NodeId id) const {
    const Node& n = tree.node(id);
    return join(tokens[n.first_token].span, tokens[n.end_token - 1].span);
  }
  std::span<const Span> comments_of(const DefinitionSyntax& definition) const {
    const auto begin = std::ranges::lower_bound(comments, definition.stretch.begin, {}, &Span::begin);
    const auto end = std::ranges::lower_bound(comments, definition.stretch.end, {}, &Span::begin);
    return {begin, end};
  }
  std::string_view node_text(NodeId id) const { return slice(span(id)); }
  /// The token is a `(` that opens the arguments of the name before it.
  bool opens_arguments(uint32_t token) const {
    return tokens[token].kind == TokenKind::OpenParen && !std::ranges::binary_search(factors, token);
  }
};

/// `\begin{equation}`, `\[` as it is written, and what belongs to it: `\end{equation}`, `\]`.
std::string begin_of_block(const ParsedBlock& block);
std::string end_of_block(const ParsedBlock& block);

/// A longer block is not read: it is one error.
inline constexpr uint32_t kMaxBlockBytes = uint32_t{1} << 20;

/// Lexes and parses one block. Never fails: what cannot be read becomes Error nodes and one diagnostic.
/// A `(` straight behind a name opens its arguments, unless it is one of `factors` (tokens, in order): `a(b + c)` is a
/// product where `a` is no function, which only semantics can tell.
ParsedBlock parse_block(std::string_view text, const BlockExtent& extent,
                        std::pmr::memory_resource* memory = std::pmr::get_default_resource(),
                        std::span<const uint32_t> factors = {});

}  // namespace texbrdf

#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "syntax/block_scanner.h"
#include "syntax/macro_expansion.h"
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
  /// In force where there is no other: a parameter is no name, as in `f(a - b) = …`, or a square is defined, `g^2 = …`.
  bool gives_way = false;
  /// False where anything in the definition could not be read (it has Error nodes).
  bool readable = true;
};

/// How a block is read where that depends on what the document makes of names, which only semantics can tell.
struct Reading {
  /// Where runs of letters end before their last: `ax^2` is a product where `a` and `x` are names. Bytes of the block,
  /// in order; where a `\Delta` begins it is a name by itself.
  std::vector<uint32_t> cuts;
  /// The `(` behind names that open a factor and no arguments: `a(b + c)` is a product where `a` is no function.
  /// Tokens, in order.
  std::vector<uint32_t> factors;
  /// Where names begin that differ from what they are read as by themselves: the `\langle` of `\langle E\rangle`, the
  /// `\hat` of a name that is another one without it. Tokens, in order.
  std::vector<uint32_t> names;

  friend bool operator==(const Reading&, const Reading&) = default;
};

/// `c` of `a = b = c`: what the definition says of its name once more.
struct Restatement {
  uint32_t definition = 0;  ///< of the block's; its nodes stand right before those of the restatement
  NodeId body;
};

/// All that a block's bytes say, without knowledge of any other block. Immutable; shared between snapshots.
struct ParsedBlock {
  /// Takes what it holds from `memory`, which has to outlive it.
  explicit ParsedBlock(std::pmr::memory_resource* memory)
      : text(memory), tokens(memory), comments(memory), tree(memory), definitions(memory), restatements(memory) {}

  /// The block's own bytes, BlockExtent::whole, in which macros are replaced by what they stand for. All spans are of
  /// this text.
  std::pmr::string text;
  /// How it came about; nullptr where the document holds the very same text.
  std::shared_ptr<const MacroExpansion> expansion;
  BlockExtent extent;               ///< as scanned; `whole` is then only good for its size
  std::pmr::vector<Token> tokens;   ///< of the content, closed by one End token
  std::pmr::vector<Span> comments;  ///< `%` to the end of the line, for `% range [0, 1]` and `% constant`
  Reading reading;                  ///< as parse_block was told
  SyntaxTree tree;
  std::pmr::vector<DefinitionSyntax> definitions;
  std::pmr::vector<Restatement> restatements;  ///< those that can be read, in order
  std::vector<Diagnostic> diagnostics;  ///< by definition, then what concerns none; their Location::block is not set
                                        ///< yet (0); spans are relative

  /// As the document has it.
  std::string_view source() const { return expansion ? std::string_view(expansion->source()) : std::string_view(text); }
  const BlockExtent& source_extent() const { return expansion ? expansion->source_extent() : extent; }
  /// Where a span of `text` stands in `source`: of what a macro made, its use.
  Span in_source(Span span) const { return expansion ? expansion->in_source(span) : span; }
  /// Another text can be put in its place there.
  bool is_replaceable(Span span) const { return !expansion || expansion->is_replaceable(span); }
  /// Of what stands in the source.
  std::optional<uint32_t> from_source(uint32_t offset) const {
    return expansion ? expansion->from_source(offset) : offset;
  }

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
  /// The last node of a definition's right sides.
  NodeId last_node(uint32_t definition) const {
    const auto behind = std::ranges::upper_bound(restatements, definition, {}, &Restatement::definition);
    const bool is_restated = behind != restatements.begin() && std::prev(behind)->definition == definition;
    return is_restated ? std::prev(behind)->body : definitions[definition].body;
  }
  std::string_view node_text(NodeId id) const { return slice(span(id)); }
  /// The token is a `(` that opens the arguments of the name before it.
  bool opens_arguments(uint32_t token) const {
    return tokens[token].kind == TokenKind::OpenParen && !std::ranges::binary_search(reading.factors, token);
  }
  /// The token is the `^` of `a^2(x)`, the power of a call, behind the name.
  bool is_power_of_call(uint32_t token) const {
    return tokens[token].kind == TokenKind::Caret && std::ranges::binary_search(reading.factors, token);
  }
  /// A name of its own begins at the token.
  bool begins_own_name(uint32_t token) const { return std::ranges::binary_search(reading.names, token); }
  /// The Name node of a parameter on a left side: the parameter itself, or the angle of `\cos\theta`. Invalid where the
  /// parameter is another expression.
  NodeId parameter_name(NodeId parameter) const;
};

/// `\begin{equation}`, `\[` as it is written, and what belongs to it: `\end{equation}`, `\]`.
std::string begin_of_block(const ParsedBlock& block);
std::string end_of_block(const ParsedBlock& block);

/// A longer block is not read: it is one error.
inline constexpr uint32_t kMaxBlockBytes = uint32_t{1} << 20;

/// Lexes and parses one block. Never fails: what cannot be read becomes Error nodes and one diagnostic.
/// Where there is an `expansion`, `text` and `extent` are those of the source.
ParsedBlock parse_block(std::string_view text, const BlockExtent& extent,
                        std::pmr::memory_resource* memory = std::pmr::get_default_resource(), Reading reading = {},
                        std::shared_ptr<const MacroExpansion> expansion = nullptr);

}  // namespace texbrdf

#include <algorithm>
#include <tuple>

#include "syntax/parser.h"

namespace texbrdf {

void Parser::parse_statement(const Statement& statement, Span stretch) {
  position_ = statement.begin;
  end_ = statement.end;
  silent_ = block_is_silent_;
  recovering_ = false;
  had_error_ = false;
  first_node_ = block_.tree.size();
  const size_t definitions = block_.definitions.size();
  const auto first = static_cast<uint32_t>(block_.diagnostics.size());

  report_brackets();
  skip_ignored();
  parse_definition(statement);
  keep_what_defines(definitions, first);
  std::ranges::sort(block_.diagnostics.begin() + first, block_.diagnostics.end(), {},
                    [](const Diagnostic& diagnostic) { return std::tie(diagnostic.where.span, diagnostic.code); });
  if (block_.definitions.size() == definitions) return;
  DefinitionSyntax& definition = block_.definitions.back();
  definition.stretch = stretch;
  definition.first_diagnostic = first;
  definition.end_diagnostic = static_cast<uint32_t>(block_.diagnostics.size());
}

/// Inline mathematics that cannot be read is prose.
void Parser::keep_what_defines(size_t definitions, size_t diagnostics) {
  if (!is_inline(block_.extent.region)) return;
  if (had_error_) block_.definitions.resize(definitions);
  if (block_.definitions.size() == definitions) block_.diagnostics.resize(diagnostics);
}

void Parser::parse_definition(const Statement& statement) {
  if (at(TokenKind::End)) {
    report_expected(Code::NoExpression);
    return;
  }
  const Part left = parse_left_side(statement);
  if (!at(TokenKind::Equals)) return;
  const uint32_t equals = advance();
  recovering_ = false;
  end_ = statement.chain;
  const Part right = parse_right_side();
  if (defines_something(left)) {
    finish(left, equals, right);
  } else if (!left.damaged) {
    report_no_definition(left, right);
  }
}

/// Ends at the `=`, or at the statement's end where there is none.
Parser::Part Parser::parse_left_side(const Statement& statement) {
  Part left = parse_expression(0);
  if (at(TokenKind::End)) {
    if (!left.damaged) report_expected(Code::MissingEquals);
    return left;
  }
  const uint32_t equals = statement.relation;
  if (equals == end_) {
    report_expected(Code::UnexpectedToken);
    skip_to_end();
    return left;
  }
  if (position_ != equals && !left.damaged) {
    report(Code::NoDefinition, statement.begin, join(tokens_[statement.begin].span, tokens_[equals - 1].span), {});
    left.damaged = true;
  }
  position_ = equals;
  return left;
}

/// A name, or a name with names in parentheses.
bool Parser::defines_something(const Part& left) const {
  if (left.damaged) return false;
  const NodeKind kind = block_.tree.node(left.node).kind;
  if (kind == NodeKind::Name) return true;
  if (kind != NodeKind::Apply) return false;
  for (const NodeId child : block_.tree.children(left.node)) {
    if (block_.tree.node(child).kind != NodeKind::Name) return false;
  }
  return true;
}

Parser::Part Parser::parse_right_side() {
  const Part right = parse_expression(0);
  if (at(TokenKind::End)) return right;
  report_expected(Code::UnexpectedToken);
  const uint32_t first = first_token(right);
  const uint32_t unexpected = position_;
  skip_to_end();
  return make(NodeKind::Error, unexpected, first, {right});
}

/// An equation of a paper that defines nothing is no error, unless its sides are swapped: `1 + 2 = f`.
void Parser::report_no_definition(const Part& left, const Part& right) {
  const auto is_name = [&](const Node& node) { return node.kind == NodeKind::Name; };
  const std::span<const Node> nodes = block_.tree.nodes();
  const bool is_swapped = is_name(nodes[right.node.value]) &&
                          std::ranges::none_of(nodes.subspan(first_node_, left.node.value - first_node_), is_name);
  Diagnostic* const diagnostic = report(Code::NoDefinition, first_token(left), block_.span(left.node), {});
  if (diagnostic != nullptr && !is_swapped) diagnostic->severity = Severity::Hint;
}

void Parser::finish(const Part& left, uint32_t equals, Part right) {
  // A closer that closes nothing leaves no trace in the tree but the value is not to be trusted.
  if (had_error_ && !right.damaged) right = make(NodeKind::Error, first_token(right), first_token(right), {right});

  SyntaxTree& tree = block_.tree;
  NodeId name = left.node;
  if (tree.node(left.node).kind == NodeKind::Apply) {
    tree.set_kind(left.node, NodeKind::Signature);
    name = tree.child(left.node, 0);
  }
  const NodeId sides[] = {left.node, right.node};
  const uint32_t end_token = std::max(tree.node(right.node).end_token, equals + 1);
  const NodeId definition = tree.add(NodeKind::Definition, equals, tree.node(left.node).first_token, end_token, sides);
  block_.definitions.push_back({.node = definition,
                                .left = left.node,
                                .name = name,
                                .body = right.node,
                                .first_node = first_node_,
                                .stretch = {},
                                .readable = !had_error_});
}

}  // namespace texbrdf

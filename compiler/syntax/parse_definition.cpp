#include "syntax/parser.h"

namespace texbrdf {

void Parser::parse_definition() {
  if (at(TokenKind::End)) {
    report_expected(Code::NoExpression);
    return;
  }
  const Part left = parse_left_side();
  if (!at(TokenKind::Equals)) return;
  const uint32_t equals = advance();
  recovering_ = false;
  const Part right = parse_right_side();
  if (defines_something(left)) finish(left, equals, right);
}

/// Ends at the `=`, or at the block's end where there is none.
Parser::Part Parser::parse_left_side() {
  const uint32_t first = position_;
  Part left = parse_expression(0);
  if (at(TokenKind::End)) {
    if (!left.damaged) report_expected(Code::MissingEquals);
    return left;
  }
  uint32_t equals = position_;
  while (equals < end_ && tokens_[equals].kind != TokenKind::Equals) ++equals;
  if (equals == end_) {
    report_expected(Code::UnexpectedToken);
    skip_to_end();
    return left;
  }
  const bool complete = equals == position_;
  position_ = equals;
  if (!left.damaged && (!complete || !defines_something(left))) {
    const Span whole = join(tokens_[first].span, tokens_[equals - 1].span);
    report(Code::NoDefinition, first, whole, {});
    left.damaged = true;
  }
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
                                .first_node = 0,
                                .readable = !had_error_});
}

}  // namespace texbrdf

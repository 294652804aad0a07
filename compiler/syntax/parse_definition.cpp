#include <algorithm>
#include <tuple>

#include "syntax/parser.h"

namespace texbrdf {
namespace {

bool is_approximation(std::string_view relation) {
  return relation == "\\approx" || relation == "\\simeq" || relation == "≈";
}

/// The next relation outside of brackets, or `end`.
uint32_t end_of_right_side(const Token* tokens, uint32_t first, uint32_t end) {
  uint32_t depth = 0;
  for (uint32_t token = first; token < end; ++token) {
    const TokenKind kind = tokens[token].kind;
    if (is_opener(kind)) {
      ++depth;
    } else if (is_closer(kind) && depth > 0) {
      --depth;
    } else if (depth == 0 && (kind == TokenKind::Equals || kind == TokenKind::Relation)) {
      return token;
    }
  }
  return end;
}

}  // namespace

void Parser::parse_statement(const Statement& statement, const Statement* next, Span stretch) {
  position_ = statement.begin;
  end_ = statement.end;
  silent_ = block_is_silent_;
  recovering_ = false;
  had_error_ = false;
  open_rows_ = 0;
  first_node_ = block_.tree.size();
  const size_t definitions = block_.definitions.size();
  const auto first = static_cast<uint32_t>(block_.diagnostics.size());

  report_brackets();
  skip_ignored();
  parse_definition(statement);
  if (block_.definitions.size() > definitions) report_unread_condition(statement, next);
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
    const bool defines_macros = block_.expansion && block_.expansion->has_definitions();
    if (!defines_macros) report_expected(Code::NoExpression);
    return;
  }
  const LeftSide left = parse_left_side(statement);
  if (!at(TokenKind::Equals)) return;
  uint32_t equals = advance();
  recovering_ = false;
  end_ = statement.chain;
  if (const uint32_t repeated = behind_repeated_left_side(statement); repeated != kNone) {
    end_ = end_of_right_side(tokens_, repeated + 1, statement.end);
    position_ = repeated;
    equals = advance();
  }
  const Part right = parse_right_side();
  // `$\cos\theta = 0$` in prose says at which angle something holds.
  const bool says_when =
      (left.function != kNone || left.square != kNone) && is_inline(block_.extent.region) && is_number(right);
  if (says_when) return;
  if (defines_something(left.part)) {
    finish(left, equals, right);
    if (!had_error_ && left.function == kNone && left.square == kNone) parse_restatements(statement);
  } else if (!left.part.damaged) {
    report_no_definition(left.part, right);
  }
}

bool Parser::is_equality(uint32_t relation) const {
  return tokens_[relation].kind == TokenKind::Equals && !is_approximation(block_.token_text(relation));
}

/// What follows in `a = b = c`. What cannot be read of it was not asked for: nothing is reported.
void Parser::parse_restatements(const Statement& statement) {
  const size_t reported = block_.diagnostics.size();
  for (uint32_t relation = end_; relation < statement.end; relation = end_) {
    end_ = end_of_right_side(tokens_, relation + 1, statement.end);
    const bool is_equal = is_equality(relation);
    position_ = relation + 1;
    if (!is_equal) continue;
    const Part right = parse_expression(0);
    const bool is_read = at(TokenKind::End) && !had_error_ && !right.damaged;
    if (is_read) block_.restatements.push_back({static_cast<uint32_t>(block_.definitions.size() - 1), right.node});
    had_error_ = recovering_ = false;
  }
  block_.diagnostics.resize(reported);
}

/// `\cos\theta = …` of `c = \cos\theta = …` also says what the angle is.
std::optional<Statement> Parser::angle_in_chain(const Statement& statement) {
  end_ = statement.end;
  if (statement.chain == statement.end || !is_equality(statement.chain)) return std::nullopt;
  const bool has_left = statement.relation > statement.begin;
  if (!has_left || kind_at(last_before(statement.relation)) == TokenKind::CloseParen) return std::nullopt;
  position_ = statement.relation + 1;
  if (!function_of_name_begins(statement.chain)) return std::nullopt;
  const uint32_t next = end_of_right_side(tokens_, statement.chain + 1, statement.end);
  return Statement{position_, statement.end, statement.chain, next, true};
}

/// `\mathbf h_r = \mathbf h_r(\mathbf i, \mathbf o) = …`: the relation behind what says the left side again, which is
/// passed over; kNone where the right side begins here.
uint32_t Parser::behind_repeated_left_side(const Statement& statement) {
  const uint32_t relation = statement.relation;
  const uint32_t chain = statement.chain;
  if (chain == statement.end || tokens_[chain].kind != TokenKind::Equals) return kNone;
  uint32_t left = statement.begin;
  uint32_t right = position_;
  const auto is_same = [&] { return block_.token_text(left) == block_.token_text(right); };
  while (left < relation && right < chain && kind_at(left) != TokenKind::OpenParen && is_same()) {
    ++left;
    ++right;
  }
  while (left < relation && is_layout(kind_at(left))) ++left;
  while (right < chain && is_layout(kind_at(right))) ++right;
  const auto ends_name = [&](uint32_t token, uint32_t end) {
    return token == end || (kind_at(token) == TokenKind::OpenParen && closer_behind(token, end) == last_before(end));
  };
  const bool is_repeated = left > statement.begin && ends_name(left, relation) && ends_name(right, chain);
  return is_repeated ? chain : kNone;
}

bool Parser::is_number(const Part& part) const {
  NodeId node = part.node;
  while (block_.tree.node(node).kind == NodeKind::Prefix) node = block_.tree.child(node, 0);
  return block_.tree.node(node).kind == NodeKind::Number;
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

void Parser::finish(const LeftSide& side, uint32_t equals, Part right) {
  const Part& left = side.part;
  // A closer that closes nothing leaves no trace in the tree but the value is not to be trusted.
  if (had_error_ && !right.damaged) right = make(NodeKind::Error, first_token(right), first_token(right), {right});
  if (side.function != kNone && !right.damaged) {
    right = make(NodeKind::Inverse, side.function, first_token(right), {right});
  } else if (side.square != kNone && !right.damaged) {
    right = make(NodeKind::Root, side.square, first_token(right), {right});
    report_square(side, equals);
  }

  SyntaxTree& tree = block_.tree;
  NodeId name = left.node;
  if (tree.node(left.node).kind == NodeKind::Apply) {
    tree.set_kind(left.node, NodeKind::Signature);
    name = tree.child(left.node, 0);
  }
  const NodeId sides[] = {left.node, right.node};
  const uint32_t end_token = std::max(tree.node(right.node).end_token, equals + 1);
  const NodeId definition = tree.add(NodeKind::Definition, equals, side.first_token, end_token, sides);
  const auto is_expression = [this](NodeId parameter) { return !block_.parameter_name(parameter).valid(); };
  const bool has_expressions =
      name != left.node && std::ranges::any_of(tree.children(left.node).subspan(1), is_expression);
  block_.definitions.push_back({.node = definition,
                                .left = left.node,
                                .name = name,
                                .body = right.node,
                                .first_node = first_node_,
                                .stretch = {},
                                .gives_way = has_expressions || side.square != kNone || side.is_part,
                                .readable = !had_error_});
  report_several_names(name);
}

}  // namespace texbrdf

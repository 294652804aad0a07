#include "analysis/tuple_fix.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "syntax/brackets.h"

namespace texbrdf {
namespace {

/// The tokens of a literal `\vec{…}`: `\vec`, `{` and `}`.
struct LiteralTokens {
  Span opening;
  Span closing;
};

LiteralTokens tokens_of(const ParsedBlock& block, NodeId literal) {
  const Node& node = block.tree.node(literal);
  uint32_t bracket = node.first_token;
  while (!is_opener(block.tokens[bracket].kind)) ++bracket;
  return {join(block.tokens[node.first_token].span, block.tokens[bracket].span), block.tokens[node.end_token - 1].span};
}

bool is_number(const ParsedBlock& block, NodeId node) {
  while (block.tree.node(node).kind == NodeKind::Prefix) node = block.tree.child(node, 0);
  return block.tree.node(node).kind == NodeKind::Number;
}

bool is_tuple_of_numbers(const ParsedBlock& block, NodeId node) {
  return block.tree.node(node).kind == NodeKind::Tuple &&
         std::ranges::all_of(block.tree.children(node), [&](NodeId child) { return is_number(block, child); });
}

class TupleFix {
 public:
  TupleFix(const Snapshot::State& state, const LocatedDefinition& inside)
      : state_(state), inside_(inside), block_(inside.at.parsed()) {}

  std::optional<Fix> run(const Diagnostic& problem) {
    return problem.code == Code::ColourProduct ? make_vector(problem) : make_tuples(problem);
  }

 private:
  std::optional<Fix> make_tuples(const Diagnostic& problem) {
    for (NodeId operand : operands(problem)) {
      if (is_vector(operand) && !turn(operand)) return std::nullopt;
    }
    if (fix_.edits.empty()) return std::nullopt;
    fix_.title = turned_.size() == 1 ? "write `" + text_ + "`, which may be a colour"
                                     : "write tuples `(…)` for `\\vec{…}`, which may be colours";
    return std::move(fix_);
  }

  /// Beside a colour a vector would be an error.
  std::optional<Fix> make_vector(const Diagnostic& problem) {
    const std::vector<NodeId> both = operands(problem);
    if (std::ranges::any_of(both, [this](NodeId id) { return type(id) == Type::Colour; })) return std::nullopt;
    for (NodeId operand : both) {
      const auto [block, body] = definition_or_self(without_groups(operand));
      if (!is_tuple_of_numbers(block.parsed(), body)) continue;
      replace_brackets(block, body, "\\vec{", "}");
      fix_.title = "write `" + text_ + "` for the dot product";
      return std::move(fix_);
    }
    return std::nullopt;
  }

  NodeId without_groups(NodeId id) const {
    while (block_.tree.node(id).kind == NodeKind::Group) id = block_.tree.child(id, 0);
    return id;
  }

  /// What the problem is about.
  std::vector<NodeId> operands(const Diagnostic& problem) const {
    const DefinitionSyntax& syntax = inside_.syntax();
    for (uint32_t i = syntax.left.value + 1; i <= syntax.body.value; ++i) {
      const NodeId id{i};
      if (problem.code == Code::OperandNotReal) {
        if (is_vector(id) && block_.span(id) == problem.where.span) return {id};
      } else if (is_operation(id) && operator_begin(id) == problem.where.span.begin) {
        return {block_.tree.children(id).begin(), block_.tree.children(id).end()};
      }
    }
    return {};
  }

  bool is_operation(NodeId id) const {
    const NodeKind kind = block_.tree.node(id).kind;
    return kind == NodeKind::Infix || kind == NodeKind::Fraction || kind == NodeKind::Juxtaposition;
  }

  uint32_t operator_begin(NodeId id) const { return block_.tokens[block_.tree.node(id).token].span.begin; }

  bool is_vector(NodeId id) const { return type(id) == Type::Vector; }
  Type type(NodeId id) const { return inside_.checked().types[id.value - inside_.syntax().first_node]; }

  /// All literals that the vector is made of; false where it is made of something else too.
  bool turn(NodeId id) {
    const NodeKind kind = block_.tree.node(id).kind;
    if (kind == NodeKind::VectorLiteral) return turn_literal(inside_.at, id);
    if (kind == NodeKind::Name) return turn_definition(id);
    if (kind != NodeKind::Group && kind != NodeKind::Prefix && !is_operation(id)) return false;
    return std::ranges::all_of(block_.tree.children(id),
                               [&](NodeId child) { return !is_vector(child) || turn(child); });
  }

  bool turn_definition(NodeId name) {
    const auto [block, body] = definition_or_self(name);
    return block.parsed().tree.node(body).kind == NodeKind::VectorLiteral && turn_literal(block, body);
  }

  /// Of a name that a definition gives, that definition's right side.
  std::pair<LocatedBlock, NodeId> definition_or_self(NodeId id) const {
    const Referent& referent = inside_.checked().referents[id.value - inside_.syntax().first_node];
    if (referent.kind != Referent::Kind::Definition) return {inside_.at, id};
    const std::optional<DefinitionKey> key = state_.find(NameId{referent.index});
    if (!key) return {inside_.at, id};
    const LocatedDefinition definition = state_.locate(*key);
    return {definition.at, definition.syntax().body};
  }

  bool turn_literal(const LocatedBlock& block, NodeId literal) {
    if (turned_.insert({block.id, literal}).second) replace_brackets(block, literal, "(", ")");
    return true;
  }

  void replace_brackets(const LocatedBlock& block, NodeId literal, const std::string& opening,
                        const std::string& closing) {
    const LiteralTokens tokens = tokens_of(block.parsed(), literal);
    const auto at = [&](Span span) { return Location{.file = {}, .block = block.id, .span = span}; };
    fix_.edits.push_back({at(tokens.opening), opening});
    fix_.edits.push_back({at(tokens.closing), closing});
    text_ = opening + std::string(block.parsed().slice({tokens.opening.end, tokens.closing.begin})) + closing;
  }

  const Snapshot::State& state_;
  const LocatedDefinition& inside_;
  const ParsedBlock& block_;
  std::set<std::pair<BlockId, NodeId>> turned_;
  std::string text_;  // of the last
  Fix fix_;
};

}  // namespace

bool may_want_tuple(Code code) {
  return code == Code::OperatorMismatch || code == Code::OperandNotReal || code == Code::MissingOperator ||
         code == Code::ColourProduct;
}

std::optional<Fix> tuple_fix(const Snapshot::State& state, const LocatedDefinition& inside, const Diagnostic& problem) {
  return TupleFix(state, inside).run(problem);
}

}  // namespace texbrdf

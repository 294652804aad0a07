#include "analysis/tuple_fix.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texbrdf {
namespace {

/// The tokens of a literal `\vec{…}`: `\vec`, `{` and `}`.
struct LiteralTokens {
  Span opening;
  Span closing;
};

LiteralTokens tokens_of(const ParsedBlock& block, NodeId literal) {
  const Node& node = block.tree.node(literal);
  uint32_t brace = node.first_token;
  while (block.tokens[brace].kind != TokenKind::OpenBrace) ++brace;
  return {join(block.tokens[node.first_token].span, block.tokens[brace].span), block.tokens[node.end_token - 1].span};
}

class TupleFix {
 public:
  TupleFix(const Snapshot::State& state, const LocatedDefinition& inside)
      : state_(state), inside_(inside), block_(inside.at.parsed()) {}

  std::optional<Fix> run(const Diagnostic& problem) {
    for (NodeId operand : operands(problem)) {
      if (is_vector(operand) && !turn(operand)) return std::nullopt;
    }
    if (fix_.edits.empty()) return std::nullopt;
    fix_.title = turned_.size() == 1 ? "write `" + text_ + "`, which may be a colour"
                                     : "write tuples `(…)` for `\\vec{…}`, which may be colours";
    return std::move(fix_);
  }

 private:
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
    const Referent& referent = inside_.checked().referents[name.value - inside_.syntax().first_node];
    if (referent.kind != Referent::Kind::Definition) return false;
    const std::optional<DefinitionKey> key = state_.find(NameId{referent.index});
    if (!key) return false;
    const LocatedDefinition definition = state_.locate(*key);
    const NodeId body = definition.syntax().body;
    const bool is_literal = definition.at.parsed().tree.node(body).kind == NodeKind::VectorLiteral;
    return is_literal && turn_literal(definition.at, body);
  }

  bool turn_literal(const LocatedBlock& block, NodeId literal) {
    if (!turned_.insert({block.id, literal}).second) return true;
    const LiteralTokens tokens = tokens_of(block.parsed(), literal);
    const auto at = [&](Span span) { return Location{.file = {}, .block = block.id, .span = span}; };
    fix_.edits.push_back({at(tokens.opening), "("});
    fix_.edits.push_back({at(tokens.closing), ")"});
    text_ = "(" + std::string(block.parsed().slice({tokens.opening.end, tokens.closing.begin})) + ")";
    return true;
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
  return code == Code::OperatorMismatch || code == Code::OperandNotReal || code == Code::MissingOperator;
}

std::optional<Fix> tuple_fix(const Snapshot::State& state, const LocatedDefinition& inside, const Diagnostic& problem) {
  return TupleFix(state, inside).run(problem);
}

}  // namespace texbrdf

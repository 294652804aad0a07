#include "features/demand.h"

#include "features/new_name.h"
#include "features/places.h"

namespace texbrdf::features {
namespace {

using Role = OpenBracket::Role;

class DemandReader {
 public:
  DemandReader(const Snapshot& snapshot, BlockId block, std::span<const OpenBracket> brackets)
      : snapshot_(snapshot), block_(block), parsed_(snapshot.parsed(block)), brackets_(brackets) {}

  /// Goes to the left while what stands there passes the demand on.
  std::optional<Type> run(uint32_t token) {
    while (token > 0) {
      const uint32_t before = token - 1;
      switch (parsed_.tokens[before].kind) {
        case TokenKind::Divide:
        case TokenKind::Caret:
        case TokenKind::Function:
        case TokenKind::Sqrt:
          return Type::Real;
        case TokenKind::Cross:
          return Type::Vector;
        case TokenKind::Plus:
        case TokenKind::Minus:
          if (const auto sum = node_of(NodeKind::Infix, before)) return type_of(parsed_.tree.child(*sum, 0));
          break;  // a sign
        case TokenKind::Ampersand:
        case TokenKind::Gap:
        case TokenKind::NewRow:
          break;
        case TokenKind::Comma:
        case TokenKind::OpenParen:
        case TokenKind::OpenBrace:
        case TokenKind::OpenBracket:
        case TokenKind::OpenSet:
        case TokenKind::OpenAngle: {
          if (brackets_.empty()) return std::nullopt;
          const OpenBracket bracket = brackets_.back();
          brackets_ = brackets_.first(brackets_.size() - 1);
          if (bracket.role == Role::Group && bracket.commas > 0) return Type::Real;
          if (!passes_on(bracket.role)) return demanded_in(bracket);
          token = bracket.first_token;
          continue;
        }
        case TokenKind::OpenMatrix:
          return Type::Real;
        case TokenKind::Number:
        case TokenKind::Word:
        case TokenKind::Macro:
        case TokenKind::Text:
        case TokenKind::Vec:
        case TokenKind::Accent:
        case TokenKind::Prime:
        case TokenKind::Extremum:
        case TokenKind::BigOperator:
        case TokenKind::Integral:
        case TokenKind::OpenIntegral:
        case TokenKind::Differential:
        case TokenKind::DifferentialFactor:
        case TokenKind::DerivativeFrac:
        case TokenKind::Frac:
        case TokenKind::Multiply:
        case TokenKind::Underscore:
        case TokenKind::Equals:
        case TokenKind::CloseParen:
        case TokenKind::CloseBrace:
        case TokenKind::CloseBracket:
        case TokenKind::CloseSet:
        case TokenKind::CloseAngle:
        case TokenKind::OpenCases:
        case TokenKind::CloseCases:
        case TokenKind::CloseMatrix:
        case TokenKind::OpenInterval:
        case TokenKind::CloseInterval:
        case TokenKind::CellEnd:
        case TokenKind::RowEnd:
        case TokenKind::Remark:
        case TokenKind::And:
        case TokenKind::Or:
        case TokenKind::Not:
        case TokenKind::Bar:
        case TokenKind::DoubleBar:
        case TokenKind::Over:
        case TokenKind::Relation:
        case TokenKind::Unknown:
        case TokenKind::End:
          return std::nullopt;
      }
      --token;
    }
    return std::nullopt;
  }

 private:
  /// A fraction has the type of its numerator.
  static bool passes_on(Role role) { return role == Role::Group || role == Role::Numerator; }

  std::optional<Type> demanded_in(const OpenBracket& bracket) const {
    switch (bracket.role) {
      case Role::Call:
        return argument_type(bracket);
      case Role::Function:
      case Role::Extremum:
      case Role::Denominator:
      case Role::RootIndex:
      case Role::Radicand:
      case Role::Exponent:
        return Type::Real;
      case Role::Group:
      case Role::Numerator:
      case Role::Subscript:
      case Role::Vec:
      case Role::Text:
      case Role::Foreign:
        break;
    }
    return std::nullopt;
  }

  std::optional<Type> argument_type(const OpenBracket& call) const {
    const auto function = callee(snapshot_, block_, call);
    if (!function) return std::nullopt;
    const Definition& definition = snapshot_.definition(*function);
    const std::vector<Type>& types = definition.checked->signature.parameters;
    if (call.commas >= types.size()) return std::nullopt;
    return known(types[call.commas]);
  }

  std::optional<NodeId> node_of(NodeKind kind, uint32_t token) const {
    for (uint32_t node = 0; node < parsed_.tree.size(); ++node) {
      const Node& found = parsed_.tree.node(NodeId{node});
      if (found.kind == kind && found.token == token) return NodeId{node};
    }
    return std::nullopt;
  }

  std::optional<Type> type_of(NodeId node) const {
    const DefinitionRange definitions = snapshot_.definitions_of(block_);
    for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) {
      const DefinitionSyntax& syntax = snapshot_.syntax(DefinitionId{id});
      if (node.value < syntax.first_node || node.value > syntax.node.value) continue;
      const Definition& definition = snapshot_.definition(DefinitionId{id});
      return known(definition.checked->types[node.value - syntax.first_node]);
    }
    return std::nullopt;
  }

  static std::optional<Type> known(Type type) { return type == Type::Error ? std::nullopt : std::optional(type); }

  const Snapshot& snapshot_;
  BlockId block_;
  const ParsedBlock& parsed_;
  std::span<const OpenBracket> brackets_;
};

}  // namespace

std::optional<Type> demanded_type(const Snapshot& snapshot, BlockId block, uint32_t token,
                                  std::span<const OpenBracket> brackets) {
  return DemandReader(snapshot, block, brackets).run(token);
}

namespace {

Span callee_span(const ParsedBlock& block, const OpenBracket& bracket) {
  return join(block.tokens[bracket.first_token].span, block.tokens[bracket.token - 1].span);
}

}  // namespace

std::string called_name(const Snapshot& snapshot, BlockId block, const OpenBracket& bracket) {
  if (bracket.role != Role::Call) return {};
  const ParsedBlock& parsed = snapshot.parsed(block);
  const Result<NewName> name = read_new_name(parsed.slice(callee_span(parsed, bracket)));
  return name ? name->canonical : std::string();
}

std::optional<DefinitionId> callee(const Snapshot& snapshot, BlockId block, const OpenBracket& bracket) {
  if (bracket.role != Role::Call) return std::nullopt;
  if (const auto named = snapshot.find(called_name(snapshot, block, bracket))) return named;
  const Span written = callee_span(snapshot.parsed(block), bracket);
  if (const auto named = snapshot.find(snapshot.parsed(block).slice(written))) return named;
  const std::optional<Occurrence> name = snapshot.occurrence_at(snapshot.absolute(block, written).begin);
  return name ? stood_for(snapshot, *name) : std::nullopt;
}

}  // namespace texbrdf::features

#include "ir/lower.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>

#include "source/internal_error.h"
#include "syntax/control_words.h"

namespace texbrdf::ir {

namespace {

struct FunctionOp {
  Command command;
  Op op;
};

constexpr std::array kFunctionOps = {
    FunctionOp{Command::Exp, Op::Exp},       FunctionOp{Command::Ln, Op::Ln},
    FunctionOp{Command::Log, Op::Ln},        FunctionOp{Command::Sin, Op::Sin},
    FunctionOp{Command::Cos, Op::Cos},       FunctionOp{Command::Tan, Op::Tan},
    FunctionOp{Command::Arcsin, Op::Arcsin}, FunctionOp{Command::Arccos, Op::Arccos},
    FunctionOp{Command::Arctan, Op::Arctan}, FunctionOp{Command::Sinh, Op::Sinh},
    FunctionOp{Command::Cosh, Op::Cosh},     FunctionOp{Command::Tanh, Op::Tanh},
};

struct InfixOp {
  TokenKind token;
  Op op;
};

constexpr std::array kInfixOps = {
    InfixOp{TokenKind::Plus, Op::Add},          InfixOp{TokenKind::Minus, Op::Subtract},
    InfixOp{TokenKind::Multiply, Op::Multiply}, InfixOp{TokenKind::Cross, Op::Cross},
    InfixOp{TokenKind::Divide, Op::Divide},     InfixOp{TokenKind::Caret, Op::Power},
};

Op function_op(Command command) {
  const auto entry = std::find_if(kFunctionOps.begin(), kFunctionOps.end(),
                                  [command](const FunctionOp& candidate) { return candidate.command == command; });
  require(entry != kFunctionOps.end(), "a function command without an op");
  return entry->op;
}

Op infix_op(TokenKind token) {
  const auto entry = std::find_if(kInfixOps.begin(), kInfixOps.end(),
                                  [token](const InfixOp& candidate) { return candidate.token == token; });
  require(entry != kInfixOps.end(), "an infix token that is no operator");
  return entry->op;
}

/// Lowers the nodes of one definition bottom-up; every lowered node has one value.
class Lowering {
 public:
  Lowering(const ParsedBlock& block, const DefinitionSyntax& definition, const CheckedDefinition& checked)
      : block_(block), definition_(definition), checked_(checked) {
    const uint32_t count = definition.node.value + 1 - definition.first_node;
    values_.resize(count);
    needed_.resize(count);
  }

  Graph run() {
    mark_needed();
    for (uint32_t i = definition_.first_node; i <= definition_.body.value; ++i) {
      if (needed_[slot({i})]) values_[slot({i})] = lower({i});
    }
    graph_.roots = {value(definition_.body)};
    return std::move(graph_);
  }

 private:
  std::size_t slot(NodeId node) const { return node.value - definition_.first_node; }
  ValueId value(NodeId node) const { return values_[slot(node)]; }
  ValueId child_value(NodeId node, uint32_t index) const { return value(block_.tree.child(node, index)); }
  Type type(NodeId node) const { return checked_.types[slot(node)]; }
  const Referent& referent(NodeId node) const { return checked_.referents[slot(node)]; }
  const Token& token(NodeId node) const { return block_.tokens[block_.tree.node(node).token]; }

  /// The body's nodes, without the names of called functions.
  void mark_needed() {
    needed_[slot(definition_.body)] = true;
    for (uint32_t i = definition_.body.value + 1; i-- > definition_.first_node;) {
      if (!needed_[slot({i})]) continue;
      auto children = block_.tree.children({i});
      if (block_.tree.node({i}).kind == NodeKind::Apply) children = children.subspan(1);
      for (const NodeId child : children) needed_[slot(child)] = true;
    }
  }

  ValueId lower(NodeId node) {
    switch (block_.tree.node(node).kind) {
      case NodeKind::Number:
        return graph_.constant(number(node));
      case NodeKind::Name:
        return name(node);
      case NodeKind::Group:
        return child_value(node, 0);
      case NodeKind::Prefix:
        if (token(node).kind == TokenKind::Plus) return child_value(node, 0);
        return graph_.add(Op::Negate, {child_value(node, 0)});
      case NodeKind::Bars:
        return length(child_value(node, 0));
      case NodeKind::Angles:
        return angles(node);
      case NodeKind::Infix:
        return infix(node);
      case NodeKind::Juxtaposition:
        return graph_.add(Op::Multiply, {child_value(node, 0), child_value(node, 1)});
      case NodeKind::Fraction:
        return graph_.add(Op::Divide, {child_value(node, 0), child_value(node, 1)});
      case NodeKind::Root:
        return root(node);
      case NodeKind::Function:
        return graph_.add(function_op(token(node).command), {child_value(node, 0)});
      case NodeKind::Inverse:
        return graph_.add(function_op(inverse_of(token(node).command)), {child_value(node, 0)});
      case NodeKind::Extremum:
        return extremum(node);
      case NodeKind::Apply:
        return call(node);
      case NodeKind::VectorLiteral:
      case NodeKind::Tuple:
        return graph_.add(Op::MakeVector, {child_value(node, 0), child_value(node, 1), child_value(node, 2)});
      case NodeKind::Error:
      case NodeKind::Signature:
      case NodeKind::Definition:
        break;
    }
    throw InternalError("a node that has no value in a sound definition");
  }

  double number(NodeId node) const {
    const std::string_view text = block_.node_text(node);
    double result = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    // Beyond the range of double: zero or infinity, which std::strtod gives (the program stays in the C locale).
    if (error == std::errc::result_out_of_range) return std::strtod(std::string(text).c_str(), nullptr);
    require(error == std::errc{} && end == text.data() + text.size(), "a number token that is no number");
    return result;
  }

  ValueId name(NodeId node) {
    const Referent& target = referent(node);
    switch (target.kind) {
      case Referent::Kind::Definition:
        return graph_.leaf(Op::Reference, type(node), target.index);
      case Referent::Kind::Convention:
        return convention(static_cast<Convention>(target.index));
      case Referent::Kind::Parameter:
        return formal(target.index);
      case Referent::Kind::Angle:
        return angle(angle_of_parameter(target));
      case Referent::Kind::None:
        break;
    }
    throw InternalError("a name that refers to nothing in a sound definition");
  }

  ValueId formal(uint32_t position) { return graph_.leaf(Op::Formal, checked_.parameters[position].type, position); }

  ValueId angle(ParameterAngle angle) {
    const ValueId direction = formal(angle.position);
    if (angle.kind == Convention::ThetaI) {
      return graph_.convention(angle.kind, std::array{convention(Convention::Normal), direction});
    }
    const ValueId tangent = convention(Convention::Tangent);
    return graph_.convention(angle.kind, std::array{tangent, convention(Convention::Bitangent), direction});
  }

  /// At most three levels deep: \theta_h is made of \vec{h}, which is made of the two directions.
  ValueId convention(Convention id) {
    ValueId& known = conventions_[static_cast<std::size_t>(id)];
    if (known.valid()) return known;
    if (const auto position = shadowing_parameter(id)) return known = formal(*position);
    std::vector<ValueId> operands;
    for (const Convention operand : convention_entry(id).operands) operands.push_back(convention(operand));
    return known = graph_.convention(id, operands);
  }

  std::optional<uint32_t> shadowing_parameter(Convention id) const {
    for (uint32_t i = 0; i < checked_.parameters.size(); ++i) {
      const auto& shadowed = checked_.parameters[i].shadowed;
      if (std::find(shadowed.begin(), shadowed.end(), id) != shadowed.end()) return i;
    }
    return std::nullopt;
  }

  ValueId infix(NodeId node) {
    const ValueId left = child_value(node, 0), right = child_value(node, 1);
    const Op op = infix_op(token(node).kind);
    if (op == Op::Multiply) return product(node, left, right);
    if (op == Op::Power && is_euler(left)) return graph_.add(Op::Exp, {right});
    if (op == Op::Cross) return graph_.add(is_cross_product(left, right) ? Op::Cross : Op::Multiply, {left, right});
    return graph_.add(op, {left, right});
  }

  bool is_euler(ValueId id) const {
    const Value& value = graph_.at(id);
    return value.op == Op::Convention && value.index == static_cast<uint32_t>(Convention::Euler);
  }

  /// Of two vectors the dot product.
  ValueId product(NodeId node, ValueId left, ValueId right) {
    const bool is_dot = is_triple(graph_.at(left).type) && type(node) == Type::Real;
    return graph_.add(is_dot ? Op::Dot : Op::Multiply, {left, right});
  }

  bool is_cross_product(ValueId left, ValueId right) const {
    const Type a = graph_.at(left).type, b = graph_.at(right).type;
    return is_triple(a) && is_triple(b) && a != Type::Colour && b != Type::Colour;
  }

  ValueId length(ValueId operand) {
    if (is_triple(graph_.at(operand).type)) return graph_.add(Op::Sqrt, {graph_.add(Op::Dot, {operand, operand})});
    return graph_.add(Op::Max, {operand, graph_.add(Op::Negate, {operand})});
  }

  ValueId angles(NodeId node) {
    if (block_.tree.node(node).child_count == 2) return product(node, child_value(node, 0), child_value(node, 1));
    return graph_.add(Op::Max, {graph_.constant(0), child_value(node, 0)});
  }

  ValueId root(NodeId node) {
    if (block_.tree.node(node).child_count == 1) return graph_.add(Op::Sqrt, {child_value(node, 0)});
    return graph_.add(Op::Root, {child_value(node, 0), child_value(node, 1)});
  }

  ValueId extremum(NodeId node) {
    const Op op = token(node).command == Command::Max ? Op::Max : Op::Min;
    ValueId result = child_value(node, 0);
    for (const NodeId child : block_.tree.children(node).subspan(1)) result = graph_.add(op, {result, value(child)});
    return result;
  }

  ValueId call(NodeId node) {
    const std::span<const NodeId> arguments = block_.tree.children(node).subspan(1);
    const bool has_spread = std::ranges::any_of(arguments, [this](NodeId argument) { return is_spread(argument); });
    if (!has_spread) return plain_call(node, [this](NodeId argument) { return value(argument); });
    return graph_.add(Op::MakeVector, {component_call(node, 0), component_call(node, 1), component_call(node, 2)});
  }

  template <typename ValueOf>
  ValueId plain_call(NodeId node, ValueOf value_of) {
    std::vector<ValueId> arguments;
    for (const NodeId child : block_.tree.children(node).subspan(1)) arguments.push_back(value_of(child));
    const NodeId name = block_.tree.child(node, 0);
    const Referent& callee = referent(name);
    require(callee.kind == Referent::Kind::Definition, "a call of what is no definition in a sound definition");
    return graph_.leaf(Op::Call, type(name), callee.index, arguments);
  }

  /// One component of a call with colours for real parameters.
  ValueId component_call(NodeId node, uint32_t component) {
    const ValueId result = plain_call(node, [&](NodeId argument) {
      const ValueId whole = value(argument);
      return is_spread(argument) ? graph_.add(Op::Component, {whole}, component) : whole;
    });
    return is_triple(graph_.at(result).type) ? graph_.add(Op::Component, {result}, component) : result;
  }

  bool is_spread(NodeId argument) const { return std::ranges::binary_search(checked_.spread_arguments, argument); }

  const ParsedBlock& block_;
  const DefinitionSyntax& definition_;
  const CheckedDefinition& checked_;
  Graph graph_;
  std::vector<ValueId> values_;
  std::vector<bool> needed_;
  std::vector<ValueId> conventions_ = std::vector<ValueId>(conventions().size());
};

}  // namespace

Graph lower_definition(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& /*names*/,
                       const CheckedDefinition& checked) {
  require(checked.sound, "lower_definition of a definition that is not sound");
  return Lowering(block, definition, checked).run();
}

}  // namespace texbrdf::ir

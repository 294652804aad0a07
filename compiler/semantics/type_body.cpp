#include "semantics/type_body.h"

#include <algorithm>
#include <string>

#include "semantics/type_walk.h"

namespace texbrdf {
namespace {

std::string ordinal(size_t number) {
  const size_t last_two = number % 100;
  const bool is_teen = last_two >= 11 && last_two <= 13;
  const std::string_view endings[] = {"th", "st", "nd", "rd"};
  const size_t last = number % 10;
  return std::to_string(number).append(endings[is_teen || last > 3 ? 0 : last]);
}

std::string count_of_arguments(size_t count) {
  return std::to_string(count).append(count == 1 ? " argument" : " arguments");
}

/// What is known of the result of an operation on an operand whose type is not known.
enum class UnknownOperand : uint8_t {
  MayNotMatter,  ///< what the rules give, whatever the operand is
  Matters,       ///< nothing
};

class OneType {
 public:
  using Value = Type;

  /// `typed.types` holds the leaves to begin with.
  OneType(const DefinitionView& view, std::span<const Type> parameters, UnknownOperand unknown, TypedBody& typed)
      : view_(view), parameters_(parameters), unknown_(unknown), typed_(typed) {}

  bool stopped() const { return false; }
  Type exactly(Type type) const { return type; }
  Type leaf(uint32_t slot) const { return typed_.types[slot]; }
  Type parameter(uint32_t position) const { return parameters_[position]; }

  Type binary(NodeId id, Operator op, Type left, Type right) {
    if (const std::optional<Type> found = result(op, left, right)) {
      const bool is_known = left != Type::Error && right != Type::Error;
      return is_known ? *found : of_unknown(*found);
    }
    if (op == Operator::SideBySide && result(Operator::Multiply, left, right)) {
      report_missing_operator(id);
    } else if (op == Operator::SideBySide) {
      report(Code::OperatorMismatch, first_place(view_.block.tree.child(id, 1)),
             {"\\cdot", symbol(left), symbol(right), std::string(operator_needs(Operator::Multiply))});
    } else if (op == Operator::Power) {
      expect_componentwise(id, view_.block.tree.child(id, 0), left);
      expect_componentwise(id, view_.block.tree.child(id, 1), right);
    } else {
      report(Code::OperatorMismatch, view_.at_token(view_.node(id).token),
             {operator_text(id), symbol(left), symbol(right), std::string(operator_needs(op))});
    }
    return Type::Error;
  }

  Type elementary(NodeId id, const std::vector<Type>& values) {
    const size_t reported = typed_.diagnostics.size();
    bool is_known = true;
    bool is_colour = false;
    const std::span<const NodeId> operands = view_.block.tree.children(id);
    for (NodeId operand : operands) {
      const Type type = values[view_.slot(operand)];
      expect_componentwise(id, operand, type);
      is_known = is_known && type != Type::Error;
      is_colour = is_colour || is_triple(type);
    }
    if (view_.node(id).kind == NodeKind::Extremum && operands.size() < 2) {
      report(Code::ArgumentCount, view_.at(id),
             {operator_text(id), "2 arguments or more", count_of_arguments(operands.size())});
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    if (is_known) return is_colour ? Type::Colour : Type::Real;
    return of_unknown(is_colour ? Type::Colour : Type::Error);
  }

  Type tuple(NodeId id, const std::vector<Type>& values) {
    const size_t reported = typed_.diagnostics.size();
    bool is_known = true;
    const std::span<const NodeId> elements = view_.block.tree.children(id);
    if (elements.size() != 3) report(Code::TupleLength, view_.at(id), {std::to_string(elements.size())});
    for (NodeId element : elements) {
      const Type type = values[view_.slot(element)];
      is_known = is_known && type != Type::Error;
      if (type == Type::Real || type == Type::Error) continue;
      report(Code::TupleElement, view_.at(view_.without_groups(element)), {symbol(type)});
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    return is_known ? Type::Tuple : of_unknown(Type::Tuple);
  }

  Type length(Type operand) { return operand == Type::Error ? of_unknown(Type::Real) : Type::Real; }

  Type call(NodeId id, const Signature& signature, const std::vector<Type>& values) {
    const std::span<const NodeId> children = view_.block.tree.children(id);
    const std::span<const NodeId> arguments = children.subspan(1);
    if (arguments.size() != signature.parameters.size()) {
      report(Code::ArgumentCount, view_.at(id),
             {view_.name_text(children[0]), count_of_arguments(signature.parameters.size()),
              std::to_string(arguments.size())});
      return Type::Error;
    }
    const size_t reported = typed_.diagnostics.size();
    bool is_known = true;
    bool may_be_spread = false;
    bool is_spread = false;
    for (size_t i = 0; i < arguments.size(); ++i) {
      const Type expected = signature.parameters[i];
      const Type got = values[view_.slot(arguments[i])];
      if (expected == Type::Error || got == Type::Error) {
        is_known = false;
        may_be_spread = may_be_spread || signature.is_spread(i);
      } else if (signature.is_spread(i) && is_triple(got) && is_componentwise(got)) {
        is_spread = true;
        typed_.spread_arguments.push_back(arguments[i]);
      } else if (!fits(got, expected)) {
        report(Code::ArgumentType, view_.at(view_.without_groups(arguments[i])),
               {ordinal(i + 1), view_.name_text(children[0]), symbol(expected), symbol(got)});
      }
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    const Type result = is_spread ? Type::Colour : signature.result;
    if (is_known) return result;
    return of_unknown(may_be_spread && result != Type::Colour ? Type::Error : result);
  }

 private:
  Type of_unknown(Type result) {
    typed_.holds_unknown = true;
    return unknown_ == UnknownOperand::MayNotMatter ? result : Type::Error;
  }

  void report(Code code, Location where, std::vector<std::string> arguments) {
    typed_.diagnostics.push_back(make_diagnostic(code, where, std::move(arguments)));
  }

  void report_missing_operator(NodeId id) {
    report(Code::MissingOperator, first_place(view_.block.tree.child(id, 1)), {});
    const uint32_t begin = view_.token(view_.node(id).token).span.begin;
    const Location before{.file = {}, .block = {}, .span = {begin, begin}};
    typed_.diagnostics.back().fixes.push_back({.title = "insert `\\cdot`", .edits = {{before, "\\cdot "}}});
  }

  void expect_componentwise(NodeId id, NodeId operand, Type type) {
    if (is_componentwise(type) || type == Type::Error) return;
    report(Code::OperandNotReal, view_.at(view_.without_groups(operand)), {operator_text(id), symbol(type)});
  }

  uint32_t first_token(NodeId id) const { return view_.node(id).first_token; }
  static std::string symbol(Type type) { return std::string(type_symbol(type)); }
  std::string operator_text(NodeId id) const { return std::string(view_.block.token_text(view_.node(id).token)); }

  // The token that an expression starts with; a name is one, with its decoration and subscripts.
  Location first_place(NodeId id) const {
    while (view_.node(id).child_count > 0 && first_token(view_.block.tree.child(id, 0)) == first_token(id)) {
      id = view_.block.tree.child(id, 0);
    }
    return view_.node(id).kind == NodeKind::Name ? view_.at(id) : view_.at_token(first_token(id));
  }

  const DefinitionView& view_;
  std::span<const Type> parameters_;
  const UnknownOperand unknown_;
  TypedBody& typed_;
};

}  // namespace

TypedBody type_body(const DefinitionView& view, const ResolvedBody& body, std::vector<Type> leaves,
                    std::span<const Type> parameters) {
  const auto walk = [&](TypedBody typed, UnknownOperand unknown) {
    OneType domain(view, parameters, unknown, typed);
    TypeWalk<OneType>(view, body, domain).run(typed.types);
    return typed;
  };
  TypedBody typed =
      walk({.types = std::move(leaves), .diagnostics = {}, .spread_arguments = {}}, UnknownOperand::MayNotMatter);
  std::ranges::sort(typed.spread_arguments);
  if (typed.types[view.slot(view.syntax.body)] == Type::Error) typed.holds_unknown = true;
  if (typed.holds_unknown) {
    // The leaves still stand among the types.
    typed.diagnostics =
        walk({.types = typed.types, .diagnostics = {}, .spread_arguments = {}}, UnknownOperand::Matters).diagnostics;
  }
  return typed;
}

}  // namespace texbrdf

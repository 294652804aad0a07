#include "semantics/type_body.h"

#include <algorithm>
#include <string>

#include "semantics/instance_facts.h"
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
  OneType(const DefinitionView& view, const ResolvedBody& body, std::span<const Type> parameters, Calls calls,
          UnknownOperand unknown, TypedBody& typed)
      : view_(view), body_(body), parameters_(parameters), calls_(calls), unknown_(unknown), typed_(typed) {}

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
             {"\\cdot", symbol(left), symbol(right), needs(Operator::Multiply, left, right)});
    } else if (op == Operator::Power) {
      expect_componentwise(id, view_.block.tree.child(id, 0), left);
      expect_componentwise(id, view_.block.tree.child(id, 1), right);
    } else {
      report(Code::OperatorMismatch, view_.at_token(view_.node(id).token),
             {operator_text(id), symbol(left), symbol(right), needs(op, left, right)});
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
    if (elements.size() == 2 && are_vectors(elements, values)) return report_vectors_in_tuple(id, elements);
    const std::optional<Type> type = tuple_type(elements.size());
    if (!type) report(Code::TupleLength, view_.at(id), {std::to_string(elements.size())});
    for (NodeId element : elements) is_known = expect_real_entry(element, values) && is_known;
    if (typed_.diagnostics.size() > reported) return Type::Error;
    return is_known ? *type : of_unknown(*type);
  }

  Type matrix(NodeId id, const std::vector<Type>& values) {
    const size_t reported = typed_.diagnostics.size();
    bool is_known = true;
    for (NodeId row : view_.block.tree.children(id)) {
      for (NodeId entry : view_.block.tree.children(row)) is_known = expect_real_entry(entry, values) && is_known;
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    const std::optional<Type> type = type_of_shape(matrix_shape(view_, id));
    return is_known ? type.value_or(Type::Error) : of_unknown(type.value_or(Type::Error));
  }

  Type determinant(NodeId id, Type operand) {
    if (operand == Type::Error) return of_unknown(Type::Real);
    if (is_square_matrix(operand)) return Type::Real;
    report(Code::SquareMatrixExpected, view_.at(view_.without_groups(view_.block.tree.child(id, 0))),
           {operator_text(id), symbol(operand)});
    return Type::Error;
  }

  /// `M^T`, where T is a number only above numbers.
  Type power_of_matrix(NodeId id, MatrixPower power, Type base, Type exponent) {
    const bool is_inverse = power == MatrixPower::Inverse || power == MatrixPower::InverseTransposed;
    if (is_inverse && is_square_matrix(base)) return base;
    if (power == MatrixPower::Inverse) return binary(id, Operator::Power, base, exponent);
    const bool has_sign = has_transposition_sign(view_, body_, id);
    const bool may_be_number = !has_sign && is_componentwise(base);
    const std::optional<Type> transpose =
        power == MatrixPower::Transposed ? transposed_base(view_, id, base) : std::nullopt;
    if (transpose && !may_be_number) return *transpose;
    if (!has_sign) return binary(id, Operator::Power, base, exponent);
    if (base == Type::Error) return of_unknown(Type::Error);
    if (is_aggregate(base)) return binary(id, Operator::Power, base, Type::Real);
    report_undefined_sign(id);
    return Type::Error;
  }

  bool are_vectors(std::span<const NodeId> elements, const std::vector<Type>& values) const {
    return std::ranges::all_of(elements, [&](NodeId id) { return values[view_.slot(id)] == Type::Vector; });
  }

  /// `(\mathbf n, \mathbf l)`
  Type report_vectors_in_tuple(NodeId id, std::span<const NodeId> elements) {
    const auto text = [&](NodeId element) { return std::string(view_.block.node_text(element)); };
    const std::string product = text(elements[0]) + " \\cdot " + text(elements[1]);
    report(Code::VectorsInTuple, view_.at(id), {product});
    typed_.diagnostics.back().fixes.push_back({.title = "write it so", .edits = {{view_.at(id), "(" + product + ")"}}});
    return Type::Real;
  }

  Type bounds(NodeId id, const std::vector<Type>& values) {
    const size_t reported = typed_.diagnostics.size();
    bool is_known = true;
    for (NodeId bound : view_.block.tree.children(id)) {
      const Type type = values[view_.slot(bound)];
      is_known = is_known && type != Type::Error;
      if (type == Type::Real || type == Type::Error) continue;
      report(Code::BoundType, view_.at(view_.without_groups(bound)), {operator_text(id), symbol(type)});
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    return is_known ? Type::Real : of_unknown(Type::Error);
  }

  Type derivative(NodeId id, Type variable, Type body) {
    if (variable == Type::Error) return of_unknown(body);
    if (variable == Type::Real) return expect_no_aggregate(id, body);
    const NodeId name = view_.block.tree.child(id, 1);
    report(Code::BoundType, view_.at(name), {view_.name_text(name), symbol(variable)});
    return Type::Error;
  }

  Type reduction(NodeId id, Type bounds, Type body) {
    if (bounds == Type::Error) return of_unknown(body);
    if (!is_product(view_, id)) return expect_no_aggregate(id, body);
    const NodeId factor = view_.block.tree.child(id, 2);
    expect_componentwise(id, factor, body);
    if (body == Type::Vector || is_aggregate(body)) return Type::Error;
    return is_triple(body) ? Type::Colour : body;
  }

  Type signed_value(NodeId id, Type operand) {
    if (operand != Type::Boolean) return operand;
    expect_componentwise(id, view_.block.tree.child(id, 0), operand);
    return Type::Error;
  }

  Type length(NodeId id, Type operand) {
    if (operand == Type::Boolean) return signed_value(id, operand);
    const bool is_vmatrix = view_.token(view_.node(id).token).kind == TokenKind::OpenMatrix;
    const bool is_matrix = is_aggregate(operand) && !type_shape(operand).is_vector();
    if (is_vmatrix || (is_matrix && is_single_bar(id))) return determinant(id, operand);
    if (is_matrix) {
      expect_componentwise(id, view_.block.tree.child(id, 0), operand);
      return Type::Error;
    }
    return operand == Type::Error ? of_unknown(Type::Real) : Type::Real;
  }

  Type comparison(NodeId id, const std::vector<Type>& values) {
    bool is_known = true;
    const size_t reported = typed_.diagnostics.size();
    for (NodeId operand : view_.block.tree.children(id)) {
      const Type type = values[view_.slot(operand)];
      is_known = is_known && type != Type::Error;
      if (type == Type::Real || type == Type::Error) continue;
      report(Code::ComparedNotReal, view_.at(view_.without_groups(operand)), {relation_text(id), symbol(type)});
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    return is_known ? Type::Boolean : of_unknown(Type::Boolean);
  }

  Type junction(NodeId id, const std::vector<Type>& values) {
    bool is_known = true;
    for (NodeId operand : view_.block.tree.children(id)) {
      is_known = expect_condition(operand, values[view_.slot(operand)]) && is_known;
    }
    return is_known ? Type::Boolean : of_unknown(Type::Boolean);
  }

  Type row(NodeId id, const std::vector<Type>& values) {
    const std::span<const NodeId> children = view_.block.tree.children(id);
    if (children.size() > 1 && !expect_condition(children[1], values[view_.slot(children[1])])) {
      typed_.holds_unknown = true;
    }
    return values[view_.slot(children[0])];
  }

  Type builtin(NodeId id, Builtin function, const std::vector<Type>& values) {
    std::vector<Type> arguments;
    for (NodeId argument : view_.block.tree.children(id).subspan(1)) arguments.push_back(values[view_.slot(argument)]);
    return call(id, signature_for(function, arguments), values);
  }

  Type derivative_call(NodeId id, const Signature& signature, const std::vector<Type>& values) {
    return expect_no_aggregate(view_.block.tree.child(id, 0), call(id, signature, values));
  }

  /// What a sum of the rows would be.
  Type cases(NodeId id, const std::vector<Type>& values) {
    const std::span<const NodeId> rows = view_.block.tree.children(id);
    Type found = values[view_.slot(rows[0])];
    bool is_known = found != Type::Error;
    for (NodeId row : rows.subspan(1)) {
      const Type next = values[view_.slot(row)];
      const std::optional<Type> both = result(Operator::Plus, found, next);
      if (!both) {
        report(Code::CaseMismatch, view_.at(view_.without_groups(view_.block.tree.child(row, 0))),
               {symbol(found), symbol(next)});
        return Type::Error;
      }
      is_known = is_known && next != Type::Error;
      found = *both;
    }
    return is_known ? found : of_unknown(found);
  }

  Type call_definition(NodeId id, NameId function, const Signature& signature, const std::vector<Type>& values) {
    if (calls_ == Calls::AsDefined || signature.open == 0) return call(id, signature, values);
    const std::span<const NodeId> children = view_.block.tree.children(id);
    std::vector<Type> arguments;
    for (NodeId argument : children.subspan(1)) arguments.push_back(values[view_.slot(argument)]);
    const std::optional<Instance> instance = called_instance(function, signature, arguments);
    const InstanceFact fact = instance ? view_.facts.instance(*instance) : InstanceFact{};
    switch (fact.kind) {
      case InstanceFact::Kind::Misfit:
        return call(id, signature, values);
      case InstanceFact::Kind::TooLarge:
        report(Code::InstanceTooLarge, view_.at(children[0]), {view_.name_text(children[0])});
        return Type::Error;
      case InstanceFact::Kind::Fits:
        break;
    }
    typed_.instance_calls.push_back({children[0], *instance, fact.result});
    typed_.types[view_.slot(children[0])] = fact.result;
    return fact.result;
  }

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
    bool may_be_instance = false;
    const bool holds_unknown =
        std::ranges::any_of(arguments, [&](NodeId argument) { return values[view_.slot(argument)] == Type::Error; });
    for (size_t i = 0; i < arguments.size(); ++i) {
      const Type expected = signature.parameters[i];
      const Type got = values[view_.slot(arguments[i])];
      if (expected == Type::Error || got == Type::Error) {
        is_known = false;
        may_be_spread = may_be_spread || signature.is_spread(i);
        const bool is_of_unknown = calls_ == Calls::MayBeInstances && signature.is_open(i) && expected != Type::Error;
        may_be_instance = may_be_instance || is_of_unknown;
      } else if (signature.is_spread(i) && is_triple(got) && is_componentwise(got)) {
        is_spread = true;
        typed_.spread_arguments.push_back(arguments[i]);
      } else if (!fits(got, expected) && holds_unknown && calls_ == Calls::MayBeInstances && signature.is_open(i)) {
        may_be_instance = true;
      } else if (!fits(got, expected)) {
        report(Code::ArgumentType, view_.at(view_.without_groups(arguments[i])),
               {ordinal(i + 1), view_.name_text(children[0]), symbol(expected), symbol(got)});
      }
    }
    if (typed_.diagnostics.size() > reported) return Type::Error;
    const Type result = is_spread ? Type::Colour : signature.result;
    if (is_known) return result;
    const bool may_differ = may_be_instance || (may_be_spread && result != Type::Colour);
    return of_unknown(may_differ ? Type::Error : result);
  }

 private:
  Type of_unknown(Type result) {
    typed_.holds_unknown = true;
    return unknown_ == UnknownOperand::MayNotMatter ? result : Type::Error;
  }

  void report(Code code, Location where, std::vector<std::string> arguments) {
    typed_.diagnostics.push_back(make_diagnostic(code, where, std::move(arguments)));
  }

  /// False where its type is not known.
  bool expect_real_entry(NodeId entry, const std::vector<Type>& values) {
    const Type type = values[view_.slot(entry)];
    if (type != Type::Real && type != Type::Error) {
      report(Code::TupleElement, view_.at(view_.without_groups(entry)), {symbol(type)});
    }
    return type != Type::Error;
  }

  /// What an operation that binds a name is taken of.
  Type expect_no_aggregate(NodeId id, Type body) {
    if (!is_aggregate(body)) return body;
    report(Code::ReducedMatrix, view_.at_token(view_.node(id).token), {operator_text(id), symbol(body)});
    return Type::Error;
  }

  bool is_single_bar(NodeId bars) const {
    const uint32_t behind = view_.node(bars).token + 1;
    const bool is_doubled =
        view_.token(behind).kind == TokenKind::Bar && behind < first_token(view_.block.tree.child(bars, 0));
    return view_.token(view_.node(bars).token).kind == TokenKind::Bar && !is_doubled;
  }

  /// The sign of the transposition above a number, which would be a name.
  void report_undefined_sign(NodeId power) {
    const NodeId sign = transposition_sign(view_, power);
    const bool is_foreign = view_.table.traits(view_.name(sign)).is_foreign_command;
    std::vector<std::string> arguments = {view_.name_text(sign)};
    if (!is_foreign) arguments.insert(arguments.end(), {view_.defined_text(), ""});
    report(is_foreign ? Code::UnknownCommand : Code::UndefinedName, view_.at(sign), std::move(arguments));
  }

  static std::string needs(Operator op, Type left, Type right) {
    const bool is_of_matrices = is_aggregate(left) || is_aggregate(right);
    return std::string(is_of_matrices ? matrix_operator_needs(op) : operator_needs(op));
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

  /// False where it is not known to be one.
  bool expect_condition(NodeId operand, Type type) {
    if (type == Type::Boolean) return true;
    if (type != Type::Error) report(Code::ConditionExpected, view_.at(view_.without_groups(operand)), {symbol(type)});
    return false;
  }

  std::string relation_text(NodeId id) const {
    return view_.node(id).kind == NodeKind::Membership ? "\\in" : operator_text(id);
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
  const ResolvedBody& body_;
  std::span<const Type> parameters_;
  const Calls calls_;
  const UnknownOperand unknown_;
  TypedBody& typed_;
};

}  // namespace

TypedBody type_body(const DefinitionView& view, const ResolvedBody& body, std::vector<Type> leaves,
                    std::span<const Type> parameters, Calls calls) {
  const auto walk = [&](TypedBody typed, UnknownOperand unknown) {
    OneType domain(view, body, parameters, calls, unknown, typed);
    TypeWalk<OneType>(view, body, domain).run(typed.types);
    return typed;
  };
  TypedBody typed = walk({.types = std::move(leaves), .diagnostics = {}, .spread_arguments = {}, .instance_calls = {}},
                         UnknownOperand::MayNotMatter);
  std::ranges::sort(typed.spread_arguments);
  std::ranges::sort(typed.instance_calls, {}, &InstanceCall::callee);
  if (typed.types[view.slot(view.syntax.body)] == Type::Error) typed.holds_unknown = true;
  if (typed.holds_unknown) {
    // The leaves still stand among the types.
    typed.diagnostics = walk({.types = typed.types, .diagnostics = {}, .spread_arguments = {}, .instance_calls = {}},
                             UnknownOperand::Matters)
                            .diagnostics;
  }
  return typed;
}

}  // namespace texbrdf

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {

namespace {

using Function = double (*)(double);

struct FunctionOfOne {
  Op op;
  Function function;
};

constexpr std::array kFunctions = {
    FunctionOfOne{Op::Sqrt, [](double x) { return std::sqrt(x); }},
    FunctionOfOne{Op::Exp, [](double x) { return std::exp(x); }},
    FunctionOfOne{Op::Ln, [](double x) { return std::log(x); }},
    FunctionOfOne{Op::Sin, [](double x) { return std::sin(x); }},
    FunctionOfOne{Op::Cos, [](double x) { return std::cos(x); }},
    FunctionOfOne{Op::Tan, [](double x) { return std::tan(x); }},
    FunctionOfOne{Op::Arcsin, [](double x) { return std::asin(x); }},
    FunctionOfOne{Op::Arccos, [](double x) { return std::acos(x); }},
    FunctionOfOne{Op::Arctan, [](double x) { return std::atan(x); }},
    FunctionOfOne{Op::Sinh, [](double x) { return std::sinh(x); }},
    FunctionOfOne{Op::Cosh, [](double x) { return std::cosh(x); }},
    FunctionOfOne{Op::Tanh, [](double x) { return std::tanh(x); }},
};

/// The value of an elementwise op, NaN for another, or where it has none or where the language has a rule beside the C
/// library's: zero bases, bases and radicands below zero, arguments just beyond ±1. Those are left to the evaluator.
double plain_value(Op op, double a, double b) {
  if (op == Op::Negate) return -a;
  if (op == Op::Add) return a + b;
  if (op == Op::Subtract) return a - b;
  if (op == Op::Multiply) return a * b;
  if (op == Op::Divide) return a / b;
  if (op == Op::Min) return std::min(a, b);
  if (op == Op::Max) return std::max(a, b);
  if (op == Op::Power && a != 0 && std::isfinite(a)) return std::pow(a, b);
  if (op == Op::Root && a > 0 && b != 0) return b == 2 ? std::sqrt(a) : std::pow(a, 1 / b);
  const auto entry = std::find_if(kFunctions.begin(), kFunctions.end(),
                                  [op](const FunctionOfOne& candidate) { return candidate.op == op; });
  return entry == kFunctions.end() ? std::numeric_limits<double>::quiet_NaN() : entry->function(a);
}

/// What is known of the conditions of a graph, by ValueId: there are no constants that are truths.
using Truths = std::unordered_map<uint32_t, bool>;

/// Adds one value to the new graph, whose operands are folded already.
class Folder {
 public:
  Folder(Graph& graph, Truths& truths) : graph_(graph), truths_(truths) {}

  ValueId fold(const Value& value, std::span<const ValueId> operands) {
    if (const auto folded = fold_to_constant(value, operands)) return *folded;
    if (const auto same = equal_operand(value, operands)) return *same;
    if (const auto simpler = fold_sign(value, operands)) return *simpler;
    const ValueId result = graph_.copy(value, operands);
    note_truth(result);
    return result;
  }

 private:
  using Triple = std::array<double, 3>;

  bool is_constant(ValueId id) const { return graph_.at(id).op == Op::Constant; }
  bool is_number(ValueId id, double number) const {
    const Value& value = graph_.at(id);
    return value.op == Op::Constant && value.constant == number && std::signbit(value.constant) == std::signbit(number);
  }

  /// The components of a number, spread, or of a vector of numbers.
  std::optional<Triple> constant_triple(ValueId id) const {
    if (is_constant(id)) {
      const double number = graph_.at(id).constant;
      return Triple{number, number, number};
    }
    if (graph_.at(id).op != Op::MakeVector) return std::nullopt;
    Triple triple;
    for (uint32_t i = 0; i < 3; ++i) {
      const ValueId component = graph_.operand(id, i);
      if (!is_constant(component)) return std::nullopt;
      triple[i] = graph_.at(component).constant;
    }
    return triple;
  }

  /// Only finite results: an infinity or NaN that is written into a document stays visible as the operation it is.
  std::optional<ValueId> fold_to_constant(const Value& value, std::span<const ValueId> operands) {
    if (operands.empty() || operands.size() > 2) return std::nullopt;
    if (is_triple(value.type)) return fold_vector(value, operands);
    if (value.op == Op::Dot) return fold_dot(operands);
    if (!std::all_of(operands.begin(), operands.end(), [this](ValueId id) { return is_constant(id); })) {
      return std::nullopt;
    }
    const double number =
        plain_value(value.op, graph_.at(operands.front()).constant, graph_.at(operands.back()).constant);
    if (!std::isfinite(number)) return std::nullopt;
    return graph_.constant(number);
  }

  std::optional<ValueId> fold_vector(const Value& value, std::span<const ValueId> operands) {
    const auto a = constant_triple(operands.front());
    const auto b = constant_triple(operands.back());
    if (!a || !b) return std::nullopt;
    Triple result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = plain_value(value.op, (*a)[i], (*b)[i]);
      if (!std::isfinite(result[i])) return std::nullopt;
    }
    const ValueId red = graph_.constant(result[0]);
    const ValueId green = graph_.constant(result[1]);
    return graph_.add(Op::MakeVector, {red, green, graph_.constant(result[2])});
  }

  std::optional<ValueId> fold_dot(std::span<const ValueId> operands) {
    const auto a = constant_triple(operands.front());
    const auto b = constant_triple(operands.back());
    if (!a || !b) return std::nullopt;
    const double number = (*a)[0] * (*b)[0] + (*a)[1] * (*b)[1] + (*a)[2] * (*b)[2];
    if (!std::isfinite(number)) return std::nullopt;
    return graph_.constant(number);
  }

  /// The operand that the value equals for every input, NaN, infinities and both zeros included.
  std::optional<ValueId> equal_operand(const Value& value, std::span<const ValueId> operands) const {
    const Op op = value.op;
    if (op == Op::Multiply) return operand_beside(operands, [this](ValueId id) { return is_number(id, 1); });
    if (op == Op::Add) return operand_beside(operands, [this](ValueId id) { return is_number(id, -0.0); });
    if (op == Op::And) return operand_beside(operands, [this](ValueId id) { return truth_of(id) == true; });
    if (op == Op::Or) return operand_beside(operands, [this](ValueId id) { return truth_of(id) == false; });
    if (op == Op::Divide && is_number(operands[1], 1)) return operands[0];
    if (op == Op::Subtract && is_number(operands[1], 0)) return operands[0];
    if ((op == Op::Min || op == Op::Max) && operands[0] == operands[1]) return operands[0];
    if (op == Op::Component && graph_.at(operands[0]).op == Op::MakeVector) {
      return graph_.operand(operands[0], value.index);
    }
    return op == Op::Select ? chosen_branch(operands) : std::nullopt;
  }

  template <typename IsNeutral>
  static std::optional<ValueId> operand_beside(std::span<const ValueId> operands, IsNeutral is_neutral) {
    if (is_neutral(operands[0])) return operands[1];
    if (is_neutral(operands[1])) return operands[0];
    return std::nullopt;
  }

  std::optional<ValueId> chosen_branch(std::span<const ValueId> operands) const {
    if (const auto truth = truth_of(operands[0])) return operands[*truth ? 1 : 2];
    if (operands[1] == operands[2]) return operands[1];
    return std::nullopt;
  }

  /// −(−x) = x, a−(−b) = a+b, a+(−b) = a−b and x·(−1) = −x, all without rounding.
  std::optional<ValueId> fold_sign(const Value& value, std::span<const ValueId> operands) {
    if (value.op == Op::Negate) return negated_operand(operands[0]);
    if (value.op == Op::Multiply) {
      if (is_number(operands[0], -1)) return graph_.add(Op::Negate, {operands[1]});
      if (is_number(operands[1], -1)) return graph_.add(Op::Negate, {operands[0]});
    }
    if (value.op != Op::Add && value.op != Op::Subtract) return std::nullopt;
    const auto positive = negated_operand(operands[1]);
    if (!positive) return std::nullopt;
    return graph_.add(value.op == Op::Add ? Op::Subtract : Op::Add, {operands[0], *positive});
  }

  std::optional<ValueId> negated_operand(ValueId id) const {
    if (graph_.at(id).op != Op::Negate) return std::nullopt;
    return graph_.operand(id, 0);
  }

  void note_truth(ValueId id) {
    const Value& value = graph_.at(id);
    if (value.type != Type::Boolean || value.operand_count == 0) return;
    if (const auto truth = find_truth(id)) truths_.emplace(id.value, *truth);
  }

  std::optional<bool> find_truth(ValueId id) const {
    const ValueId first = graph_.operand(id, 0);
    const ValueId second = graph_.operand(id, graph_.at(id).operand_count - 1);
    const Op op = graph_.at(id).op;
    if (op == Op::And) return junction(truth_of(first), truth_of(second), false);
    if (op == Op::Or) return junction(truth_of(first), truth_of(second), true);
    if (op == Op::Less || op == Op::LessEqual || op == Op::Equal) return comparison(op, first, second);
    if (const auto truth = truth_of(first); op == Op::Not && truth) return !*truth;
    return std::nullopt;
  }

  std::optional<bool> truth_of(ValueId id) const {
    const auto known = truths_.find(id.value);
    return known == truths_.end() ? std::nullopt : std::optional(known->second);
  }

  /// And is decided by one false operand, or by two true ones; Or the other way round.
  static std::optional<bool> junction(std::optional<bool> a, std::optional<bool> b, bool decisive) {
    if (a == decisive || b == decisive) return decisive;
    if (a && b) return !decisive;
    return std::nullopt;
  }

  std::optional<bool> comparison(Op op, ValueId first, ValueId second) const {
    if (!is_constant(first) || !is_constant(second)) return std::nullopt;
    const double a = graph_.at(first).constant;
    const double b = graph_.at(second).constant;
    if (op == Op::Less) return a < b;
    return op == Op::LessEqual ? a <= b : a == b;
  }

  Graph& graph_;
  Truths& truths_;
};

}  // namespace

Graph fold_constants(const Graph& graph) {
  Truths truths;
  return rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
    return Folder(result, truths).fold(graph.at(id), operands);
  });
}

}  // namespace texbrdf::ir

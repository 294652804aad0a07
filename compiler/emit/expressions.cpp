#include "emit/expressions.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "emit/number.h"
#include "semantics/conventions.h"

namespace texbrdf::emit {
namespace {

using ir::Op;
using ir::Value;
using ir::ValueId;

/// Powers with whole exponents up to this are products.
constexpr double kLargestProduct = 8;
constexpr std::array kProducts{Helper::Square, Helper::Cube, Helper::Pow4, Helper::Pow5,
                               Helper::Pow6,   Helper::Pow7, Helper::Pow8};

bool is_whole(double number) {
  return std::floor(number) == number;
}

}  // namespace

ExpressionId write_number(ExpressionPool& pool, double number) {
  ExpressionId zero = pool.atom("0.0");
  if (std::isnan(number)) return pool.infix(Precedence::Multiplicative, "/", zero, zero);
  double magnitude = std::abs(number);
  bool too_large = std::isinf(static_cast<float>(magnitude));
  ExpressionId positive = too_large ? pool.infix(Precedence::Multiplicative, "/", pool.atom("1.0"), zero)
                                    : pool.atom(float_literal(magnitude));
  return std::signbit(number) ? pool.prefix("-", positive) : positive;
}

ExpressionId ExpressionWriter::write(ValueId id, std::span<const ExpressionId> written) {
  written_ = written;
  const Value& value = graph_.at(id);
  switch (value.op) {
#define INFIX(op, precedence, text) \
  case Op::op:                      \
    return infix(Precedence::precedence, text, operand(id, 0), operand(id, 1));
#define CALL(op, function) \
  case Op::op:             \
    return pool_.call(function, operands(id));
#include "emit/operators.def"
#undef INFIX
#undef CALL
    case Op::Multiply:
      return product(operand(id, 0), operand(id, 1));
    case Op::Divide:
      return quotient(id);
    case Op::Constant:
      return number(value.constant);
    case Op::Convention:
      return convention(id);
    case Op::Negate:
      return pool_.prefix("-", operand(id, 0));
    case Op::Not:
      return pool_.prefix("!", operand(id, 0));
    case Op::Component:
      return pool_.member(operand(id, 0), std::array{"x", "y", "z"}[value.index]);
    case Op::Select:
      return pool_.conditional(operand(id, 0), operand(id, 1), operand(id, 2));
    case Op::Min:
    case Op::Max:
      return extremum(id);
    case Op::Power:
      return power(id);
    case Op::Root: {
      const Value& index = graph_.at(graph_.operand(id, 1));
      if (index.op == Op::Constant && index.constant == 1) return operand(id, 0);
      if (index.op == Op::Constant && index.constant == 2) return pool_.call("sqrt", {operand(id, 0)});
      return helper(Helper::Root, spread_operands(id), is_triple_value(id));
    }
    case Op::Arccos:
      return inverse_cosine_or_sine(id, "acos", Helper::Arccos);
    case Op::Arcsin:
      return inverse_cosine_or_sine(id, "asin", Helper::Arcsin);
    case Op::Parameter:
    case Op::Reference:
    case Op::Formal:
    case Op::BoundVariable:
    case Op::Call:
    case Op::Sum:
    case Op::Product:
    case Op::Integral:
    case Op::Derivative:
    case Op::MakeMatrix:
    case Op::Entry:
      break;
  }
  throw InternalError("a value that is no expression of its own");
}

std::vector<ExpressionId> ExpressionWriter::operands(ValueId id) const {
  std::vector<ExpressionId> result;
  for (ValueId operand : graph_.operands(id)) result.push_back(written_[operand.value]);
  return result;
}

std::vector<ExpressionId> ExpressionWriter::spread_operands(ValueId id) {
  std::vector<ExpressionId> result = operands(id);
  if (!is_triple_value(id)) return result;
  for (uint32_t i = 0; i < result.size(); ++i) {
    if (!is_triple_value(graph_.operand(id, i))) result[i] = pool_.call("vec3", {result[i]});
  }
  return result;
}

/// A component of a triple is no greater than its length.
Range ExpressionWriter::range(ValueId id, uint32_t index) const {
  const ValueId operand = graph_.operand(id, index);
  const Range& found = ranges_[operand.value];
  return is_triple_value(operand) ? Range{-found.most, found.most, found.can_fail} : found;
}

ExpressionId ExpressionWriter::helper(Helper helper, std::vector<ExpressionId> arguments, bool of_triples) {
  helpers_.insert({helper, of_triples});
  return pool_.call(helper_name(helper), std::move(arguments));
}

ExpressionId ExpressionWriter::dot_operands(ValueId id, uint32_t first, uint32_t second) {
  return pool_.call("dot", {operand(id, first), operand(id, second)});
}

/// a * (1 / b) is written a / b, and a * (x * x) is written a * x * x: the same up to rounding.
ExpressionId ExpressionWriter::product(ExpressionId left, ExpressionId right) {
  const Expression& factor = pool_.at(right);
  if (factor.kind != Expression::Kind::Infix || factor.precedence != Precedence::Multiplicative)
    return infix(Precedence::Multiplicative, "*", left, right);
  const auto [first, second] = std::pair{factor.operands[0], factor.operands[1]};
  if (factor.text == "/" && pool_.at(first).text == "1.0") return infix(Precedence::Multiplicative, "/", left, second);
  bool of_one_name = pool_.at(second).kind == Expression::Kind::Atom && is_repeated(first, pool_.at(second).text);
  if (factor.text == "*" && of_one_name) return infix(Precedence::Multiplicative, "*", product(left, first), second);
  return infix(Precedence::Multiplicative, "*", left, right);
}

/// Mesa takes the reciprocal of a zero that it knows as 0: x / 0 is written x * infinity, which is the same.
ExpressionId ExpressionWriter::quotient(ValueId id) {
  const Value& divisor = graph_.at(graph_.operand(id, 1));
  bool of_number = graph_.at(graph_.operand(id, 0)).op == Op::Constant;
  if (divisor.op != Op::Constant || divisor.constant != 0 || of_number)
    return infix(Precedence::Multiplicative, "/", operand(id, 0), operand(id, 1));
  return infix(Precedence::Multiplicative, "*", operand(id, 0), number(1 / divisor.constant));
}

/// `name`, or name * name.
bool ExpressionWriter::is_repeated(ExpressionId id, std::string_view name) const {
  const Expression& e = pool_.at(id);
  if (e.kind == Expression::Kind::Atom) return e.text == name;
  return e.kind == Expression::Kind::Infix && e.text == "*" && is_repeated(e.operands[0], name) &&
         is_repeated(e.operands[1], name);
}

/// Conventions that are made of others, as conventions.def says.
ExpressionId ExpressionWriter::convention(ValueId id) {
  switch (static_cast<Convention>(graph_.at(id).index)) {
    case Convention::Half:
      return pool_.call("normalize", {infix(Precedence::Additive, "+", operand(id, 0), operand(id, 1))});
    case Convention::ThetaI:
    case Convention::ThetaO:
    case Convention::ThetaH:
    case Convention::ThetaD:
      return pool_.call("acos", {clamped(dot_operands(id, 0, 1))});
    case Convention::PhiI:
    case Convention::PhiO:
    case Convention::PhiH:
      return pool_.call("atan", {dot_operands(id, 2, 1), dot_operands(id, 2, 0)});
    case Convention::Pi:
      return number(kPi);
    case Convention::Epsilon:
      return number(kEpsilon);
    case Convention::Euler:
      return number(kEuler);
    case Convention::OmegaI:
    case Convention::OmegaO:
    case Convention::Normal:
    case Convention::Tangent:
    case Convention::Bitangent:
      break;
  }
  throw InternalError("an input that is no expression of its own");
}

ExpressionId ExpressionWriter::extremum(ValueId id) {
  bool is_min = graph_.at(id).op == Op::Min;
  if (range(id, 0).can_fail || range(id, 1).can_fail)
    return helper(is_min ? Helper::Minimum : Helper::Maximum, spread_operands(id), is_triple_value(id));
  if (auto clamped = clamp(id)) return *clamped;
  std::vector<ExpressionId> arguments = operands(id);
  bool real_first = !is_triple_value(graph_.operand(id, 0)) && is_triple_value(graph_.operand(id, 1));
  if (real_first) std::swap(arguments[0], arguments[1]);  // GLSL has min(vec3, float) only
  return pool_.call(is_min ? "min" : "max", std::move(arguments));
}

/// min(max(x, least), most) with numbers in order is clamp(x, least, most), and so is max(min(…)).
std::optional<ExpressionId> ExpressionWriter::clamp(ValueId id) {
  Op outer = graph_.at(id).op;
  auto number_beside = [&](ValueId extremum) -> std::optional<uint32_t> {
    for (uint32_t i : {0u, 1u})
      if (graph_.at(graph_.operand(extremum, i)).op == Op::Constant) return i;
    return std::nullopt;
  };
  std::optional<uint32_t> bound = number_beside(id);
  if (!bound) return std::nullopt;
  ValueId inner = graph_.operand(id, 1 - *bound);
  if (graph_.at(inner).op != (outer == Op::Min ? Op::Max : Op::Min) || uses_[inner.value] != 1) return std::nullopt;
  std::optional<uint32_t> inner_bound = number_beside(inner);
  if (!inner_bound) return std::nullopt;
  double least = graph_.at(graph_.operand(inner, *inner_bound)).constant;
  double most = graph_.at(graph_.operand(id, *bound)).constant;
  if (outer == Op::Max) std::swap(least, most);
  if (!(least <= most)) return std::nullopt;
  return pool_.call("clamp", {operand(inner, 1 - *inner_bound), number(least), number(most)});
}

ExpressionId ExpressionWriter::power(ValueId id) {
  ExpressionId base = operand(id, 0);
  bool of_triples = is_triple_value(id);
  const Value& exponent = graph_.at(graph_.operand(id, 1));
  if (exponent.op == Op::Constant) {
    double magnitude = std::abs(exponent.constant);
    auto or_reciprocal = [&](ExpressionId power) {
      return exponent.constant < 0 ? infix(Precedence::Multiplicative, "/", number(1), power) : power;
    };
    if (magnitude == 0) return of_triples ? pool_.call("vec3", {number(1)}) : number(1);
    if (is_whole(magnitude) && magnitude <= kLargestProduct)
      return or_reciprocal(whole_power(base, static_cast<uint32_t>(magnitude), of_triples));
    if (magnitude == 0.5) return or_reciprocal(pool_.call("sqrt", {base}));
  }
  bool may_be_whole = exponent.op != Op::Constant || is_whole(exponent.constant);
  bool defined = range(id, 0).least > 0 || (range(id, 0).least >= 0 && range(id, 1).least > 0);
  if (defined && !may_be_whole) return pool_.call("pow", spread_operands(id));
  return helper(Helper::Power, spread_operands(id), of_triples);
}

ExpressionId ExpressionWriter::whole_power(ExpressionId base, uint32_t exponent, bool of_triples) {
  if (exponent == 1) return base;
  if (exponent > 3 || pool_.at(base).kind != Expression::Kind::Atom)
    return helper(kProducts[exponent - 2], {base}, of_triples);
  ExpressionId product = base;
  for (uint32_t i = 1; i < exponent; ++i) product = infix(Precedence::Multiplicative, "*", product, base);
  return product;
}

ExpressionId ExpressionWriter::inverse_cosine_or_sine(ValueId id, std::string_view function, Helper tolerant) {
  ExpressionId x = operand(id, 0);
  if (range(id, 0).least < -1 || range(id, 0).most > 1) return helper(tolerant, {x}, is_triple_value(id));
  Op op = graph_.at(graph_.operand(id, 0)).op;
  bool is_clamped = op == Op::Min || op == Op::Max;
  return pool_.call(function, {is_clamped ? x : clamped(x)});
}

}  // namespace texbrdf::emit

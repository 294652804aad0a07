#include "ir/differential_rules.h"

#include <algorithm>
#include <array>
#include <vector>

#include "source/internal_error.h"

namespace texbrdf::ir {

Dual DualRules::apply(const Value& value, std::span<const Dual> operands) const {
  std::vector<ValueId> values;
  for (const Dual& operand : operands) values.push_back(operand.value);
  const ValueId result = graph_.copy(value, values);
  const bool changes = std::ranges::any_of(operands, [](const Dual& dual) { return dual.tangent.has_value(); });
  if (!changes || value.type == Type::Boolean) return {result, {}};
  std::optional<ValueId> change = tangent(value, result, operands);
  if (change) change = add_spread(graph_, *change, value.type);
  return {result, change};
}

std::optional<ValueId> DualRules::tangent(const Value& value, ValueId result, std::span<const Dual> operands) const {
  const auto a = [&]() -> ValueId { return operands[0].value; };
  const auto da = [&]() -> const std::optional<ValueId>& { return operands[0].tangent; };
  const auto db = [&]() -> const std::optional<ValueId>& { return operands[1].tangent; };
  switch (value.op) {
    case Op::Constant:
    case Op::Parameter:
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::And:
    case Op::Or:
    case Op::Not:
      return std::nullopt;
    case Op::Convention:
      return of_convention(value, result, operands);
    case Op::MakeVector:
      return of_vector(operands);
    case Op::Component:
      return component(*da(), value.index);
    case Op::Select:
      return of_choice(value, operands);
    case Op::Negate:
      return negative(da());
    case Op::Add:
      return sum(da(), db());
    case Op::Subtract:
      return sum(da(), negative(db()));
    case Op::Multiply:
    case Op::Dot:
    case Op::Cross:
      return of_product(value.op, operands[0], operands[1]);
    case Op::Divide:
      return over(sum(da(), negative(scaled(result, db()))), operands[1].value);
    case Op::Min:
    case Op::Max:
      return of_extremum(value, operands);
    case Op::Power:
      return of_power(result, operands[0], operands[1]);
    case Op::Root:
      return of_root(result, operands[0], operands[1]);
    case Op::Sqrt:
      return over(da(), add(Op::Multiply, {number(2), result}));
    case Op::Exp:
      return scaled(result, da());
    case Op::Ln:
      return over(da(), a());
    case Op::Sin:
      return scaled(add(Op::Cos, {a()}), da());
    case Op::Cos:
      return negative(scaled(add(Op::Sin, {a()}), da()));
    case Op::Tan:
      return scaled(add(Op::Add, {number(1), square(result)}), da());
    case Op::Arcsin:
      return over(da(), add(Op::Sqrt, {add(Op::Subtract, {number(1), square(a())})}));
    case Op::Arccos:
      return negative(over(da(), add(Op::Sqrt, {add(Op::Subtract, {number(1), square(a())})})));
    case Op::Arctan:
      return over(da(), add(Op::Add, {number(1), square(a())}));
    case Op::Arctan2:
      return of_arctan2(operands[0], operands[1]);
    case Op::Sinh:
      return scaled(add(Op::Cosh, {a()}), da());
    case Op::Cosh:
      return scaled(add(Op::Sinh, {a()}), da());
    case Op::Tanh:
      return scaled(add(Op::Subtract, {number(1), square(result)}), da());
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
  throw InternalError("an operation that has no rule of its own");
}

std::optional<ValueId> DualRules::sum(const std::optional<ValueId>& a, const std::optional<ValueId>& b) const {
  if (!a || !b) return a ? a : b;
  return add(Op::Add, {*a, *b});
}

std::optional<ValueId> DualRules::scaled(ValueId factor, const std::optional<ValueId>& tangent) const {
  return tangent ? std::optional(add(Op::Multiply, {factor, *tangent})) : std::nullopt;
}

std::optional<ValueId> DualRules::negative(const std::optional<ValueId>& tangent) const {
  return tangent ? std::optional(add(Op::Negate, {*tangent})) : std::nullopt;
}

std::optional<ValueId> DualRules::over(const std::optional<ValueId>& tangent, ValueId divisor) const {
  return tangent ? std::optional(add(Op::Divide, {*tangent, divisor})) : std::nullopt;
}

std::optional<ValueId> DualRules::of_product(Op op, const Dual& a, const Dual& b) const {
  std::optional<ValueId> left, right;
  if (a.tangent) left = add(op, {*a.tangent, b.value});
  if (b.tangent) right = add(op, {a.value, *b.tangent});
  return sum(left, right);
}

/// By branch: what is not chosen has no say.
std::optional<ValueId> DualRules::of_choice(const Value& value, std::span<const Dual> operands) const {
  const auto branch = [&](const Dual& dual) {
    return dual.tangent ? add_spread(graph_, *dual.tangent, value.type) : add_constant(graph_, 0, value.type);
  };
  if (!operands[1].tangent && !operands[2].tangent) return std::nullopt;
  return add(Op::Select, {operands[0].value, branch(operands[1]), branch(operands[2])});
}

std::optional<ValueId> DualRules::of_extremum(const Value& value, std::span<const Dual> operands) const {
  const auto part = [&](const Dual& dual, uint32_t i) {
    return dual.tangent ? component(*dual.tangent, i) : number(0);
  };
  const auto chosen = [&](uint32_t i) {
    const ValueId a = component(operands[0].value, i), b = component(operands[1].value, i);
    const ValueId takes_second = value.op == Op::Min ? add(Op::Less, {b, a}) : add(Op::Less, {a, b});
    return add(Op::Select, {takes_second, part(operands[1], i), part(operands[0], i)});
  };
  if (!is_triple(value.type)) return chosen(0);
  return add(Op::MakeVector, {chosen(0), chosen(1), chosen(2)});
}

/// Of a real itself.
ValueId DualRules::component(ValueId id, uint32_t index) const {
  return is_triple(graph_.at(id).type) ? graph_.add(Op::Component, {id}, index) : id;
}

std::optional<ValueId> DualRules::of_power(ValueId result, const Dual& base, const Dual& exponent) const {
  std::optional<ValueId> by_base, by_exponent;
  if (base.tangent) {
    const ValueId less = add(Op::Subtract, {exponent.value, number(1)});
    const ValueId slope = add(Op::Multiply, {exponent.value, add(Op::Power, {base.value, less})});
    by_base = add(Op::Multiply, {slope, *base.tangent});
  }
  if (exponent.tangent) {
    const ValueId slope = add(Op::Multiply, {result, add(Op::Ln, {base.value})});
    by_exponent = add(Op::Multiply, {slope, *exponent.tangent});
  }
  return sum(by_base, by_exponent);
}

std::optional<ValueId> DualRules::of_root(ValueId result, const Dual& radicand, const Dual& index) const {
  std::optional<ValueId> by_radicand, by_index;
  if (radicand.tangent) {
    const ValueId slope = add(Op::Divide, {result, add(Op::Multiply, {index.value, radicand.value})});
    by_radicand = add(Op::Multiply, {slope, *radicand.tangent});
  }
  if (index.tangent) {
    const ValueId logarithm = add(Op::Multiply, {result, add(Op::Ln, {radicand.value})});
    const ValueId slope = add(Op::Divide, {logarithm, square(index.value)});
    by_index = add(Op::Negate, {add(Op::Multiply, {slope, *index.tangent})});
  }
  return sum(by_radicand, by_index);
}

std::optional<ValueId> DualRules::of_arctan2(const Dual& y, const Dual& x) const {
  const ValueId length = add(Op::Add, {square(x.value), square(y.value)});
  return over(sum(scaled(x.value, y.tangent), negative(scaled(y.value, x.tangent))), length);
}

std::optional<ValueId> DualRules::of_vector(std::span<const Dual> operands) const {
  std::array<ValueId, 3> parts;
  for (size_t i = 0; i < parts.size(); ++i) parts[i] = operands[i].tangent ? *operands[i].tangent : number(0);
  return add(Op::MakeVector, {parts[0], parts[1], parts[2]});
}

/// Angles and the half vector, of what their directions are.
std::optional<ValueId> DualRules::of_convention(const Value& value, ValueId result,
                                                std::span<const Dual> operands) const {
  switch (static_cast<Convention>(value.index)) {
    case Convention::Half: {
      const std::optional<ValueId> change = sum(operands[0].tangent, operands[1].tangent);
      const ValueId whole = add(Op::Add, {operands[0].value, operands[1].value});
      const ValueId along = add(Op::Multiply, {result, add(Op::Dot, {result, *change})});
      return over(add(Op::Subtract, {*change, along}), add(Op::Sqrt, {add(Op::Dot, {whole, whole})}));
    }
    case Convention::ThetaI:
    case Convention::ThetaO:
    case Convention::ThetaH:
    case Convention::ThetaD: {
      const std::optional<ValueId> cosine = of_product(Op::Dot, operands[0], operands[1]);
      return negative(over(cosine, add(Op::Sin, {result})));
    }
    case Convention::PhiI:
    case Convention::PhiO:
    case Convention::PhiH: {
      const Dual x{add(Op::Dot, {operands[2].value, operands[0].value}), of_product(Op::Dot, operands[2], operands[0])};
      const Dual y{add(Op::Dot, {operands[2].value, operands[1].value}), of_product(Op::Dot, operands[2], operands[1])};
      return of_arctan2(y, x);
    }
    case Convention::OmegaI:
    case Convention::OmegaO:
    case Convention::Normal:
    case Convention::Tangent:
    case Convention::Bitangent:
    case Convention::Pi:
    case Convention::Epsilon:
    case Convention::Euler:
      break;
  }
  return std::nullopt;
}

}  // namespace texbrdf::ir

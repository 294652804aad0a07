#include "ir/lower_builtin.h"

#include <initializer_list>
#include <vector>

#include "semantics/conventions.h"
#include "source/internal_error.h"

namespace texbrdf::ir {
namespace {

constexpr double kRadiansPerDegree = kPi / 180;

/// Each function in terms of operations.
class BuiltinCall {
 public:
  BuiltinCall(Graph& graph, std::span<const ValueId> arguments) : graph_(graph), arguments_(arguments) {}

  ValueId lower(Builtin function) {
    switch (function) {
      case Builtin::Saturate:
        return saturate(argument(0));
      case Builtin::Clamp:
        return clamp(argument(0), argument(1), argument(2));
      case Builtin::Mix:
        return mix(argument(0), argument(1), argument(2));
      case Builtin::Step:
        return by_component([this](std::span<const ValueId> x) {
          return graph_.add(Op::Select, {add(Op::Less, {x[1], x[0]}), constant(0), constant(1)});
        });
      case Builtin::UnitStep:
        return by_component([this](std::span<const ValueId> x) {
          return graph_.add(Op::Select, {add(Op::Less, {constant(0), x[0]}), constant(1), constant(0)});
        });
      case Builtin::Smoothstep:
        return smoothstep(argument(0), argument(1), argument(2));
      case Builtin::Abs:
        return add(Op::Max, {argument(0), graph_.add(Op::Negate, {argument(0)})});
      case Builtin::Sign:
        return by_component([this](std::span<const ValueId> x) { return sign(x[0]); });
      case Builtin::Pow:
        return add(Op::Power, {argument(0), argument(1)});
      case Builtin::Sqr:
        return add(Op::Multiply, {argument(0), argument(0)});
      case Builtin::Sqrt:
        return graph_.add(Op::Sqrt, {argument(0)});
      case Builtin::Exp2:
        return add(Op::Power, {constant(2), argument(0)});
      case Builtin::Log2:
        return add_logarithm(graph_, argument(0), constant(2));
      case Builtin::Log10:
        return add_logarithm(graph_, argument(0), constant(10));
      case Builtin::Asin:
        return graph_.add(Op::Arcsin, {argument(0)});
      case Builtin::Acos:
        return graph_.add(Op::Arccos, {argument(0)});
      case Builtin::Atan:
        return graph_.add(Op::Arctan, {argument(0)});
      case Builtin::Atan2:
        return by_component([this](std::span<const ValueId> x) { return add(Op::Arctan2, {x[0], x[1]}); });
      case Builtin::Radians:
        return add(Op::Multiply, {argument(0), constant(kRadiansPerDegree)});
      case Builtin::Length:
        return length(argument(0));
      case Builtin::Normalize:
        return add(Op::Divide, {argument(0), length(argument(0))});
      case Builtin::Dot:
        return add(Op::Dot, {argument(0), argument(1)});
      case Builtin::Cross:
        return add(Op::Cross, {argument(0), argument(1)});
      case Builtin::Reflect:
        return reflect(argument(0), argument(1));
      case Builtin::Det:
      case Builtin::Trace:
        break;  // of matrices, see lower_matrices.cpp
    }
    throw InternalError("a built-in function that is not in the table");
  }

 private:
  ValueId argument(size_t position) const { return arguments_[position]; }
  ValueId constant(double number) { return graph_.constant(number); }
  /// Operands of a list are made in order.
  ValueId add(Op op, std::initializer_list<ValueId> operands) { return graph_.add(op, operands); }

  ValueId saturate(ValueId x) {
    const ValueId zero = constant(0);
    return clamp(x, zero, constant(1));
  }

  ValueId clamp(ValueId x, ValueId least, ValueId most) { return add(Op::Min, {add(Op::Max, {x, least}), most}); }

  ValueId mix(ValueId from, ValueId to, ValueId share) {
    const ValueId rest = add(Op::Subtract, {constant(1), share});
    return add(Op::Add, {add(Op::Multiply, {from, rest}), add(Op::Multiply, {to, share})});
  }

  ValueId smoothstep(ValueId from, ValueId to, ValueId x) {
    const ValueId share = add(Op::Divide, {add(Op::Subtract, {x, from}), add(Op::Subtract, {to, from})});
    const ValueId t = saturate(share);
    const ValueId slope = add(Op::Subtract, {constant(3), add(Op::Multiply, {constant(2), t})});
    return add(Op::Multiply, {add(Op::Multiply, {t, t}), slope});
  }

  ValueId sign(ValueId x) {
    const ValueId below = graph_.add(Op::Select, {add(Op::Less, {x, constant(0)}), constant(-1), x});
    return graph_.add(Op::Select, {add(Op::Less, {constant(0), x}), constant(1), below});
  }

  ValueId length(ValueId vector) { return graph_.add(Op::Sqrt, {add(Op::Dot, {vector, vector})}); }

  ValueId reflect(ValueId direction, ValueId normal) {
    const ValueId twice = add(Op::Multiply, {constant(2), add(Op::Dot, {normal, direction})});
    return add(Op::Subtract, {direction, add(Op::Multiply, {twice, normal})});
  }

  /// What is made of reals only; a colour among the arguments is taken apart.
  template <typename Function>
  ValueId by_component(Function function) {
    bool has_triple = false;
    for (const ValueId id : arguments_) has_triple = has_triple || is_triple(graph_.at(id).type);
    if (!has_triple) return function(arguments_);
    ValueId components[3];
    for (uint32_t i = 0; i < 3; ++i) {
      std::vector<ValueId> parts;
      for (const ValueId id : arguments_) {
        parts.push_back(is_triple(graph_.at(id).type) ? graph_.add(Op::Component, {id}, i) : id);
      }
      components[i] = function(parts);
    }
    return graph_.add(Op::MakeVector, {components[0], components[1], components[2]});
  }

  Graph& graph_;
  std::span<const ValueId> arguments_;
};

}  // namespace

ValueId add_logarithm(Graph& graph, ValueId operand, ValueId base) {
  return graph.add(Op::Divide, {graph.add(Op::Ln, {operand}), graph.add(Op::Ln, {base})});
}

ValueId lower_builtin(Graph& graph, Builtin function, std::span<const ValueId> arguments) {
  return BuiltinCall(graph, arguments).lower(function);
}

}  // namespace texbrdf::ir

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ir/graph.h"
#include "support/random.h"

namespace texbrdf::test {

struct RandomGraphOptions {
  int values = 40;     ///< how many operations, about
  int parameters = 2;  ///< Parameter 0 is real, in [0.1, 1]; 1 a colour with components in [0, 1]; and so on by turns
  bool reductions = true;
};

/// A flattened graph with one root of every kind of op but Call, Reference and Formal. The range of every value is
/// tracked, so that none is NaN, infinite or badly conditioned where directions are unit vectors: two evaluators must
/// agree on it up to rounding.
class RandomGraph {
 public:
  RandomGraph(uint64_t seed, const RandomGraphOptions& options) : random_(seed), options_(options) {}

  ir::Graph make() {
    add_leaves();
    for (int i = 0; i < options_.values; ++i) add_operation(true);
    graph_.roots = {root()};
    return std::move(graph_);
  }

 private:
  using Op = ir::Op;
  using ValueId = ir::ValueId;

  /// A value, the range of its components, and a bound on its rounding error in units of the last place of 1.
  struct Ranged {
    ValueId id;
    double low;
    double high;
    double error = 1;

    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
  };

  /// Beyond this error two right evaluators could differ by more than a test allows.
  static constexpr double kLargestError = 2000;

  /// Made of several values, so that most of the graph is alive.
  ValueId root() {
    const ValueId sum = graph_.add(Op::Add, {reals_[reals_.size() - 1].id, reals_[reals_.size() - 2].id});
    if (random_.chance(0.3)) return graph_.add(Op::Add, {sum, reals_[reals_.size() - 3].id});
    const ValueId vector =
        graph_.add(Op::MakeVector, {sum, reals_[reals_.size() - 3].id, reals_[reals_.size() - 4].id});
    return graph_.add(Op::Add, {vector, triples_.back().id});
  }

  void add_leaves() {
    std::vector<ValueId> by_convention;
    for (const ConventionEntry& entry : conventions()) {
      std::vector<ValueId> operands;
      for (const Convention operand : entry.operands) operands.push_back(by_convention[static_cast<size_t>(operand)]);
      by_convention.push_back(graph_.convention(entry.id, operands));
      if (is_triple(entry.type)) {
        triples_.push_back({by_convention.back(), -1, 1});
      } else {
        reals_.push_back({by_convention.back(), -3.1416, 3.1416});
        if (!entry.operands.empty()) angles_.push_back(by_convention.back());
      }
    }
    for (int i = 0; i < options_.parameters; ++i) {
      const auto index = static_cast<uint32_t>(i);
      if (i % 2 == 0) reals_.push_back({graph_.leaf(Op::Parameter, Type::Real, index), 0.1, 1});
      if (i % 2 != 0) triples_.push_back({graph_.leaf(Op::Parameter, Type::Colour, index), 0, 1});
    }
    for (int i = 0; i < 4; ++i) add_constant();
  }

  void add_constant() {
    const std::vector<double> numbers{0, 1, -1, 2, 0.5, -0.25, 3, random_.real(-2, 2)};
    const double number = random_.one_of(numbers);
    reals_.push_back({graph_.constant(number), number, number});
  }

  Ranged real() { return reals_[reals_.size() - 1 - random_.below(std::min<size_t>(reals_.size(), 14))]; }
  Ranged triple() { return triples_[triples_.size() - 1 - random_.below(std::min<size_t>(triples_.size(), 8))]; }

  /// A real that lies in [low, high]: any that does, or the sine of one, scaled.
  Ranged real_within(double low, double high) {
    const Ranged any = real();
    if (any.low >= low && any.high <= high) return any;
    const ValueId sine = graph_.add(Op::Sin, {any.id});
    const ValueId scaled = graph_.add(Op::Multiply, {graph_.constant((high - low) * 0.499), sine});
    const ValueId moved = graph_.add(Op::Add, {scaled, graph_.constant((low + high) * 0.5)});
    return {moved, low, high, any.error * (high - low) + 4};
  }

  /// The same of a triple, component by component.
  Ranged triple_within(double low, double high) {
    const Ranged any = triple();
    if (any.low >= low && any.high <= high) return any;
    const ValueId sine = graph_.add(Op::Sin, {any.id});
    const ValueId scaled = graph_.add(Op::Multiply, {graph_.constant((high - low) * 0.499), sine});
    const ValueId moved = graph_.add(Op::Add, {graph_.constant((low + high) * 0.5), scaled});
    return {moved, low, high, any.error * (high - low) + 4};
  }

  /// `slope`: a bound on the derivative by any operand. Numbers are kept small, uncertain ones are not used.
  void push_real(ValueId id, double low, double high, double slope, std::initializer_list<Ranged> operands) {
    Ranged value{id, low, high, std::max(std::abs(low), std::abs(high)) + 1};
    for (const Ranged& operand : operands) value.error += slope * operand.error;
    if (value.error > kLargestError) return;
    if (value.magnitude() > 20) value = {graph_.add(Op::Tanh, {id}), -1, 1, value.error};
    reals_.push_back(value);
  }

  void push_triple(ValueId id, double low, double high, double slope, std::initializer_list<Ranged> operands) {
    Ranged value{id, low, high, std::max(std::abs(low), std::abs(high)) + 1};
    for (const Ranged& operand : operands) value.error += slope * operand.error;
    if (value.error > kLargestError) return;
    if (value.magnitude() > 20) {
      const double scale = 10 / value.magnitude();
      value = {graph_.add(Op::Multiply, {graph_.constant(scale), id}), -10, 10, value.error};
    }
    triples_.push_back(value);
  }

  void add_operation(bool may_reduce) {
    switch (random_.below(may_reduce && options_.reductions ? 14 : 13)) {
      case 0:
        return add_sum_or_difference();
      case 1:
        return add_product();
      case 2:
        return add_quotient();
      case 3:
        return add_extremum();
      case 4:
        return add_bounded_function();
      case 5:
        return add_function_of_limited_argument();
      case 6:
        return add_power();
      case 7:
        return add_select();
      case 8:
        return add_vector();
      case 9:
        return add_vector_operation();
      case 10:
        return add_constant();
      case 11:
        return add_function_of_angles();
      case 12:
        return add_operation_by_component();
      default:
        return add_reduction();
    }
  }

  void add_sum_or_difference() {
    const Ranged a = real(), b = real();
    if (random_.chance(0.5)) {
      push_real(graph_.add(Op::Add, {a.id, b.id}), a.low + b.low, a.high + b.high, 1, {a, b});
    } else {
      push_real(graph_.add(Op::Subtract, {a.id, b.id}), a.low - b.high, a.high - b.low, 1, {a, b});
    }
  }

  void add_product() {
    const Ranged a = real(), b = random_.chance(0.3) ? a : real();
    const double bound = a.magnitude() * b.magnitude(), slope = std::max(a.magnitude(), b.magnitude());
    push_real(graph_.add(Op::Multiply, {a.id, b.id}), a.id == b.id ? 0 : -bound, bound, slope, {a, b});
  }

  void add_quotient() {
    const Ranged a = real(), b = real_within(0.25, 8);
    const double bound = a.magnitude() * 4;
    push_real(graph_.add(Op::Divide, {a.id, b.id}), -bound, bound, 4 + 4 * bound, {a, b});
  }

  void add_extremum() {
    const Ranged a = real(), b = real();
    if (random_.chance(0.5)) {
      push_real(graph_.add(Op::Min, {a.id, b.id}), std::min(a.low, b.low), std::min(a.high, b.high), 1, {a, b});
    } else {
      push_real(graph_.add(Op::Max, {a.id, b.id}), std::max(a.low, b.low), std::max(a.high, b.high), 1, {a, b});
    }
  }

  void add_bounded_function() {
    const Ranged a = real();
    switch (random_.below(5)) {
      case 0:
        return push_real(graph_.add(Op::Sin, {a.id}), -1, 1, 1, {a});
      case 1:
        return push_real(graph_.add(Op::Cos, {a.id}), -1, 1, 1, {a});
      case 2:
        return push_real(graph_.add(Op::Tanh, {a.id}), -1, 1, 1, {a});
      case 3:
        return push_real(graph_.add(Op::Arctan, {a.id}), -1.6, 1.6, 1, {a});
      default:
        return push_real(graph_.add(Op::Negate, {a.id}), -a.high, -a.low, 1, {a});
    }
  }

  /// What the pass that removes angles looks for, and a little beyond.
  void add_function_of_angles() {
    ValueId angle = random_.one_of(angles_);
    if (random_.chance(0.2)) angle = graph_.add(Op::Multiply, {graph_.constant(2), angle});
    if (random_.chance(0.2)) angle = graph_.add(Op::Negate, {angle});
    if (random_.chance(0.5)) {
      angle = graph_.add(random_.chance(0.5) ? Op::Add : Op::Subtract, {angle, random_.one_of(angles_)});
    }
    if (random_.chance(0.1)) angle = graph_.add(Op::Add, {angle, real_within(-1, 1).id});
    const ValueId function = graph_.add(random_.chance(0.5) ? Op::Cos : Op::Sin, {angle});
    reals_.push_back({function, -1, 1, 10});
  }

  /// An op with the arguments that it is given, its range there, and a bound on its derivative.
  struct LimitedFunction {
    Op op;
    double from, to;
    double low, high;
    double slope;
  };

  static const std::vector<LimitedFunction>& limited_functions() {
    static const std::vector<LimitedFunction> functions{
        {Op::Tan, -0.9, 0.9, -1.3, 1.3, 2.6},   {Op::Arcsin, -0.9, 0.9, -1.2, 1.2, 2.3},
        {Op::Arccos, -0.9, 0.9, 0.4, 2.7, 2.3}, {Op::Exp, -0.9, 0.9, 0.4, 2.5, 2.5},
        {Op::Sinh, -0.9, 0.9, -1.1, 1.1, 1.5},  {Op::Cosh, -0.9, 0.9, 1, 1.5, 1.1},
        {Op::Sqrt, 0.3, 6, 0.5, 2.5, 1},        {Op::Ln, 0.3, 6, -1.3, 1.8, 3.4},
    };
    return functions;
  }

  void add_function_of_limited_argument() {
    if (random_.chance(0.1)) {
      const Ranged y = real_within(-0.9, 0.9), x = real_within(0.3, 6);
      return push_real(graph_.add(Op::Arctan2, {y.id, x.id}), -1.6, 1.6, 3.4, {y, x});
    }
    const LimitedFunction& f = random_.one_of(limited_functions());
    const Ranged argument = real_within(f.from, f.to);
    push_real(graph_.add(f.op, {argument.id}), f.low, f.high, f.slope, {argument});
  }

  void add_power() {
    switch (random_.below(4)) {
      case 0: {
        const Ranged base = real_within(0.3, 6);
        const ValueId index = graph_.constant(random_.between(2, 5));
        return push_real(graph_.add(Op::Root, {base.id, index}), 0.5, 2.5, 1.2, {base});
      }
      case 1: {
        const Ranged base = real_within(0.3, 4), exponent = real_within(-1.5, 1.5);
        return push_real(graph_.add(Op::Power, {base.id, exponent.id}), 0, 15, 30, {base, exponent});
      }
      case 2: {
        const Ranged base = real_within(0.5, 1.6);
        const ValueId exponent = graph_.constant(-random_.between(1, 5));
        return push_real(graph_.add(Op::Power, {base.id, exponent}), 0, 32, 320, {base});
      }
      default: {
        const Ranged base = real_within(-1.2, 1.2);
        const ValueId exponent = graph_.constant(random_.between(0, 9));
        return push_real(graph_.add(Op::Power, {base.id, exponent}), -6, 6, 40, {base});
      }
    }
  }

  ValueId condition() {
    const Op op = random_.one_of(std::vector<Op>{Op::Less, Op::LessEqual, Op::Equal});
    const ValueId simple = graph_.add(op, {real().id, real().id});
    const ValueId other = graph_.add(Op::Less, {real().id, real().id});
    switch (random_.below(5)) {
      case 0:
        return graph_.add(Op::And, {simple, other});
      case 1:
        return graph_.add(Op::Or, {simple, other});
      case 2:
        return graph_.add(Op::Not, {simple});
      default:
        return simple;
    }
  }

  /// Of the branch that is not taken anything may come: √(−1), 1/0.
  void add_select() {
    if (random_.chance(0.3)) {
      const Ranged a = triple(), b = triple();
      const ValueId chosen = graph_.add(Op::Select, {condition(), a.id, b.id});
      return push_triple(chosen, std::min(a.low, b.low), std::max(a.high, b.high), 1, {a, b});
    }
    const Ranged a = real();
    if (random_.chance(0.4)) {
      const ValueId below = graph_.add(Op::LessEqual, {a.id, graph_.constant(0.0625)});
      const ValueId reciprocal_root = graph_.add(Op::Divide, {graph_.constant(1), graph_.add(Op::Sqrt, {a.id})});
      const ValueId chosen = graph_.add(Op::Select, {below, graph_.constant(2), reciprocal_root});
      return push_real(chosen, 0, 4, 32, {a});
    }
    const Ranged b = real();
    const ValueId chosen = graph_.add(Op::Select, {condition(), a.id, b.id});
    push_real(chosen, std::min(a.low, b.low), std::max(a.high, b.high), 1, {a, b});
  }

  void add_vector() {
    const Ranged a = real(), b = real(), c = real();
    push_triple(graph_.add(Op::MakeVector, {a.id, b.id, c.id}), std::min({a.low, b.low, c.low}),
                std::max({a.high, b.high, c.high}), 1, {a, b, c});
  }

  void add_vector_operation() {
    const Ranged a = triple(), b = triple(), s = real();
    const double scaled = s.magnitude() * a.magnitude(), scaling = std::max(s.magnitude(), a.magnitude());
    const double bound = 3 * a.magnitude() * b.magnitude(), slope = 3 * std::max(a.magnitude(), b.magnitude());
    switch (random_.below(8)) {
      case 0:
        return push_triple(graph_.add(Op::Add, {a.id, b.id}), a.low + b.low, a.high + b.high, 1, {a, b});
      case 1:
        return push_triple(graph_.add(Op::Subtract, {a.id, b.id}), a.low - b.high, a.high - b.low, 1, {a, b});
      case 2:
        return push_triple(graph_.add(Op::Multiply, {s.id, a.id}), -scaled, scaled, scaling, {s, a});
      case 3:
        return push_triple(graph_.add(Op::Multiply, {a.id, s.id}), -scaled, scaled, scaling, {a, s});
      case 4: {
        const Ranged divisor = real_within(0.5, 3);
        const double largest = 2 * a.magnitude();
        return push_triple(graph_.add(Op::Divide, {a.id, divisor.id}), -largest, largest, 2 + 2 * largest,
                           {a, divisor});
      }
      case 5:
        return push_triple(graph_.add(Op::Cross, {a.id, b.id}), -bound, bound, slope, {a, b});
      case 6:
        return push_real(graph_.add(Op::Component, {a.id}, static_cast<uint32_t>(random_.below(3))), a.low, a.high, 1,
                         {a});
      default:
        return push_real(graph_.add(Op::Dot, {a.id, b.id}), -bound, bound, slope, {a, b});
    }
  }

  /// What colours have beyond vectors.
  void add_operation_by_component() {
    const Ranged a = triple(), b = triple(), s = real();
    const double bound = a.magnitude() * b.magnitude(), slope = std::max(a.magnitude(), b.magnitude());
    switch (random_.below(8)) {
      case 0:
        return push_triple(graph_.add(Op::Multiply, {a.id, b.id}), -bound, bound, slope, {a, b});
      case 1: {
        const Ranged divisor = triple_within(0.5, 3);
        const double largest = 2 * a.magnitude();
        return push_triple(graph_.add(Op::Divide, {a.id, divisor.id}), -largest, largest, 2 + 2 * largest,
                           {a, divisor});
      }
      case 2: {
        const Ranged divisor = triple_within(0.5, 3);
        const double largest = 2 * s.magnitude();
        return push_triple(graph_.add(Op::Divide, {s.id, divisor.id}), -largest, largest, 2 + 2 * largest,
                           {s, divisor});
      }
      case 3:
        return push_triple(graph_.add(Op::Subtract, {s.id, a.id}), s.low - a.high, s.high - a.low, 1, {s, a});
      case 4: {
        const Ranged other = random_.chance(0.5) ? b : s;
        const bool is_min = random_.chance(0.5);
        const ValueId least = graph_.add(
            is_min ? Op::Min : Op::Max, {random_.chance(0.5) ? a.id : other.id, random_.chance(0.5) ? other.id : a.id});
        if (!is_triple(graph_.at(least).type)) return;
        return push_triple(least, std::min(a.low, other.low), std::max(a.high, other.high), 1, {a, other});
      }
      case 5: {
        const LimitedFunction& f = random_.one_of(limited_functions());
        const Ranged argument = triple_within(f.from, f.to);
        return push_triple(graph_.add(f.op, {argument.id}), f.low, f.high, f.slope, {argument});
      }
      case 6: {
        const Ranged base = triple_within(0.3, 4);
        const Ranged exponent = random_.chance(0.5) ? triple_within(-1.5, 1.5) : real_within(-1.5, 1.5);
        return push_triple(graph_.add(Op::Power, {base.id, exponent.id}), 0, 15, 30, {base, exponent});
      }
      default: {
        const Ranged base = triple_within(-1.2, 1.2);
        const ValueId exponent = graph_.constant(random_.between(0, 9));
        return push_triple(graph_.add(Op::Power, {base.id, exponent}), -6, 6, 40, {base});
      }
    }
  }

  void add_reduction() {
    if (graph_.binder_count() >= 16) return;
    const int first = random_.between(0, 2), last = first + random_.between(-1, 3);
    const std::vector<Ranged> outer_reals = reals_, outer_triples = triples_;
    const uint32_t binder = graph_.new_binder();
    const ValueId low = graph_.constant(first), high = graph_.constant(last);
    reals_.push_back({graph_.leaf(Op::BoundVariable, Type::Real, binder), 0, 5});
    for (int i = random_.between(1, 4); i > 0; --i) add_operation(random_.chance(0.2));
    const Ranged body = real_within(-1.5, 1.5);
    reals_ = outer_reals;
    triples_ = outer_triples;
    push_real(graph_.add(random_.chance(0.5) ? Op::Sum : Op::Product, {low, high, body.id}, binder), -7, 7, 14, {body});
  }

  Random random_;
  RandomGraphOptions options_;
  ir::Graph graph_;
  std::vector<Ranged> reals_;
  std::vector<Ranged> triples_;
  std::vector<ValueId> angles_;
};

inline ir::Graph random_graph(uint64_t seed, const RandomGraphOptions& options = {}) {
  return RandomGraph(seed, options).make();
}

}  // namespace texbrdf::test

#include "emit/ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "semantics/conventions.h"

namespace texbrdf::emit {
namespace {

using ir::Op;
using ir::Value;
using ir::ValueId;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHalfTurn = kPi;

Range anything(bool can_fail) {
  return {-kInfinity, kInfinity, can_fail};
}

/// 0 * infinity is a bound of 0 here: the infinity is never reached.
double bound_product(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

Range product(const Range& a, const Range& b, bool can_fail) {
  std::array corners{bound_product(a.least, b.least), bound_product(a.least, b.most), bound_product(a.most, b.least),
                     bound_product(a.most, b.most)};
  auto [least, most] = std::ranges::minmax(corners);
  return {least, most, can_fail};
}

Range reciprocal(const Range& a) {
  if (a.least >= 0) return {1 / a.most, a.least == 0 ? kInfinity : 1 / a.least, a.can_fail};
  if (a.most < 0) return {1 / a.most, 1 / a.least, a.can_fail};
  return anything(a.can_fail);
}

class RangeFinder {
 public:
  RangeFinder(const ir::Graph& graph, const ProgramRanges& program, const std::vector<bool>& formals_can_fail)
      : graph_(graph), definitions_(program.definitions), formals_can_fail_(formals_can_fail) {}

  std::vector<Range> run() {
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      Range range = is_triple(graph_.at({i}).type) ? length({i}) : real({i});
      if (std::isnan(range.least) || std::isnan(range.most)) range = anything(true);
      ranges_.push_back(range);
    }
    return std::move(ranges_);
  }

 private:
  const Range& of(ValueId id, uint32_t operand) const { return ranges_[graph_.operand(id, operand).value]; }

  bool any_operand_fails(ValueId id) const {
    return std::ranges::any_of(graph_.operands(id), [&](ValueId operand) { return ranges_[operand.value].can_fail; });
  }

  Range length(ValueId id) const {
    const Value& value = graph_.at(id);
    bool fails = any_operand_fails(id);
    switch (value.op) {
      case Op::Convention:
        return {1, 1, false};
      case Op::Reference:
        return definitions_[value.index];
      case Op::Negate:
        return of(id, 0);
      case Op::Add:
      case Op::Subtract:
        return {0, largest(id, 0) + largest(id, 1), fails};
      case Op::Cross:
        return {0, bound_product(largest(id, 0), largest(id, 1)), fails};
      case Op::Multiply:
        return {0, bound_product(largest(id, 0), largest(id, 1)), fails};
      case Op::Sin:
      case Op::Cos:
      case Op::Tanh:
        return {0, std::sqrt(3.0), fails};
      case Op::Arcsin:
      case Op::Arccos:
        return {0, kHalfTurn * std::sqrt(3.0), fails || of(id, 0).most > 1};
      case Op::Sqrt:
      case Op::Ln:
      case Op::Root:
        return {0, kInfinity, true};
      case Op::Power:
        return {0, kInfinity, fails || !has_whole_exponent(id)};
      case Op::Formal:
        return {0, kInfinity, formals_can_fail_[value.index]};
      case Op::Call:
        return {0, definitions_[value.index].most, fails || definitions_[value.index].can_fail};
      default:
        return {0, kInfinity, fails};
    }
  }

  double largest(ValueId id, uint32_t operand) const {
    const Range& range = of(id, operand);
    bool spread = !is_triple(graph_.at(graph_.operand(id, operand)).type);
    return std::max(std::abs(range.least), std::abs(range.most)) * (spread ? std::sqrt(3.0) : 1);
  }

  Range real(ValueId id) const {
    const Value& value = graph_.at(id);
    bool fails = any_operand_fails(id);
    switch (value.op) {
      case Op::Constant:
        return {value.constant, value.constant, std::isnan(value.constant)};
      case Op::Parameter:
        return anything(false);
      case Op::Convention:
        return convention(static_cast<Convention>(value.index));
      case Op::Reference:
        return definitions_[value.index];
      case Op::Negate:
        return {-of(id, 0).most, -of(id, 0).least, fails};
      case Op::Add:
        return {of(id, 0).least + of(id, 1).least, of(id, 0).most + of(id, 1).most, fails};
      case Op::Subtract:
        return {of(id, 0).least - of(id, 1).most, of(id, 0).most - of(id, 1).least, fails};
      case Op::Multiply:
        return multiply(id, fails);
      case Op::Divide:
        return product(of(id, 0), reciprocal(of(id, 1)), fails);
      case Op::Min:
        return {std::min(of(id, 0).least, of(id, 1).least), std::min(of(id, 0).most, of(id, 1).most), fails};
      case Op::Max:
        return {std::max(of(id, 0).least, of(id, 1).least), std::max(of(id, 0).most, of(id, 1).most), fails};
      case Op::Select:
        return {std::min(of(id, 1).least, of(id, 2).least), std::max(of(id, 1).most, of(id, 2).most), fails};
      case Op::Power:
        return power(id, fails);
      case Op::Root:
        return {of(id, 0).least >= 0 ? 0 : -kInfinity, kInfinity, fails || of(id, 0).least < 0};
      case Op::Dot:
        return dot(id, fails);
      case Op::Component:
        return {-of(id, 0).most, of(id, 0).most, fails};
      case Op::Sqrt:
        return {std::sqrt(std::max(0.0, of(id, 0).least)), root(of(id, 0).most), fails || of(id, 0).least < 0};
      case Op::Exp:
        return {std::exp(of(id, 0).least), std::exp(of(id, 0).most), fails};
      case Op::Ln:
        return {-kInfinity, kInfinity, fails || of(id, 0).least < 0};
      case Op::Sin:
      case Op::Cos:
      case Op::Tanh:
        return {-1, 1, fails};
      case Op::Arcsin:
        return {-kHalfTurn / 2, kHalfTurn / 2, fails || !within_unit(of(id, 0))};
      case Op::Arccos:
        return {0, kHalfTurn, fails || !within_unit(of(id, 0))};
      case Op::Arctan:
        return {-kHalfTurn / 2, kHalfTurn / 2, fails};
      case Op::Arctan2:
        return {-kHalfTurn, kHalfTurn, fails};
      case Op::Cosh:
        return {1, kInfinity, fails};
      case Op::Formal:
        return anything(formals_can_fail_[value.index]);
      case Op::Call: {
        const Range& result = definitions_[value.index];
        return {result.least, result.most, fails || result.can_fail};
      }
      case Op::BoundVariable:
      case Op::Less:
      case Op::LessEqual:
      case Op::Equal:
      case Op::And:
      case Op::Or:
      case Op::Not:
        return anything(false);
      case Op::Tan:
      case Op::Sinh:
      case Op::Sum:
      case Op::Product:
      case Op::Integral:
      case Op::Derivative:
      case Op::MakeMatrix:
      case Op::Entry:
      case Op::MakeVector:
      case Op::Cross:
        return anything(fails);
    }
    return anything(true);
  }

  static double root(double x) { return x < 0 ? 0 : std::sqrt(x); }

  static bool within_unit(const Range& range) { return range.least >= -1 && range.most <= 1; }

  static Range convention(Convention id) {
    if (auto constant = convention_constant(id)) return {*constant, *constant, false};
    bool azimuth = id == Convention::PhiI || id == Convention::PhiO || id == Convention::PhiH;
    return {azimuth ? -kHalfTurn : 0, kHalfTurn, false};
  }

  Range multiply(ValueId id, bool fails) const {
    Range range = product(of(id, 0), of(id, 1), fails);
    if (graph_.operand(id, 0) == graph_.operand(id, 1)) range.least = std::max(range.least, 0.0);
    return range;
  }

  Range dot(ValueId id, bool fails) const {
    double most = bound_product(of(id, 0).most, of(id, 1).most);
    return {graph_.operand(id, 0) == graph_.operand(id, 1) ? 0 : -most, most, fails};
  }

  Range power(ValueId id, bool fails) const {
    const Range& base = of(id, 0);
    const Range& exponent = of(id, 1);
    bool whole = has_whole_exponent(id);
    bool even = whole && std::fmod(exponent.least, 2) == 0;
    if (base.least >= 0 || even) {
      bool shrinks = base.least >= -1 && base.most <= 1 && exponent.least >= 0;
      return {0, shrinks ? 1 : kInfinity, fails};
    }
    return anything(fails || !whole);
  }

  bool has_whole_exponent(ValueId id) const {
    const Range& exponent = of(id, 1);
    bool is_real = !is_triple(graph_.at(graph_.operand(id, 1)).type);
    return is_real && exponent.least == exponent.most && std::floor(exponent.least) == exponent.least;
  }

  const ir::Graph& graph_;
  const std::vector<Range>& definitions_;
  const std::vector<bool>& formals_can_fail_;
  std::vector<Range> ranges_;
};

/// Notes which formals are given values that can fail; true if any is new.
bool note_failing_arguments(const ir::Graph& graph, const std::vector<Range>& ranges, ProgramRanges& program) {
  bool changed = false;
  for (uint32_t i = 0; i < graph.size(); ++i) {
    const Value& value = graph.at({i});
    if (value.op != Op::Call) continue;
    std::vector<bool>& can_fail = program.formals_can_fail[value.index];
    for (uint32_t argument = 0; argument < can_fail.size(); ++argument) {
      if (can_fail[argument] || !ranges[graph.operand({i}, argument).value].can_fail) continue;
      can_fail[argument] = true;
      changed = true;
    }
  }
  return changed;
}

bool sweep(const ir::Program& program, ProgramRanges& ranges) {
  bool changed = false;
  ranges.definitions.clear();
  for (std::size_t i = 0; i < program.definitions.size(); ++i) {
    const ir::Graph& graph = program.definitions[i].graph;
    std::vector<Range> values = find_ranges(graph, ranges, ranges.formals_can_fail[i]);
    ranges.definitions.push_back(values[graph.roots[0].value]);
    changed = note_failing_arguments(graph, values, ranges) || changed;
  }
  return changed;
}

/// Failing arguments handed on through more functions than this make all formals count as failing.
constexpr int kMostSweeps = 8;

}  // namespace

std::vector<Range> find_ranges(const ir::Graph& graph, const ProgramRanges& program,
                               const std::vector<bool>& formals_can_fail) {
  return RangeFinder(graph, program, formals_can_fail).run();
}

ProgramRanges find_ranges(const ir::Program& program) {
  ProgramRanges ranges;
  for (const ir::ProgramDefinition& definition : program.definitions)
    ranges.formals_can_fail.emplace_back(definition.formals.size());
  for (int i = 0; i < kMostSweeps; ++i)
    if (!sweep(program, ranges)) return ranges;
  for (std::vector<bool>& can_fail : ranges.formals_can_fail) can_fail.assign(can_fail.size(), true);
  sweep(program, ranges);
  return ranges;
}

}  // namespace texbrdf::emit

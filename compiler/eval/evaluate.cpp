#include "eval/evaluate.h"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "eval/limits.h"
#include "eval/real_functions.h"
#include "source/internal_error.h"

namespace texbrdf::eval {

namespace {

using ir::Op;
using ir::ValueId;

Triple spread(double x) {
  return {x, x, x};
}

template <typename Function>
Triple map(Function function, const Triple& a, const Triple& b) {
  return {function(a[0], b[0]), function(a[1], b[1]), function(a[2], b[2])};
}

template <typename Function>
Triple by_component(const ir::Value& v, Function function, const Triple& a) {
  if (!is_triple(v.type)) return spread(function(a[0]));
  return {function(a[0]), function(a[1]), function(a[2])};
}

template <typename Function>
Triple by_component(const ir::Value& v, Function function, const Triple& a, const Triple& b) {
  return is_triple(v.type) ? map(function, a, b) : spread(function(a[0], b[0]));
}

double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple normalised_sum(const Triple& a, const Triple& b) {
  const Triple sum = map(std::plus<>{}, a, b);
  return map(std::divides<>{}, sum, spread(std::sqrt(dot(sum, sum))));
}

double angle_between(const Triple& a, const Triple& b) {
  return std::acos(clamp(dot(a, b), -1, 1));
}

bool is_bound(double x) {
  return std::fabs(x) <= kMaxBound && is_integer(x);
}

/// One evaluation: the values computed so far. A real stands three times, a truth is 0 or 1, so that every operation
/// works by components.
class Walk {
 public:
  Walk(const ir::Graph& graph, const Geometry& geometry, std::span<const Triple> parameters)
      : graph_(graph), geometry_(geometry), parameters_(parameters), values_(graph.size()) {
    loops_.resize(graph.binder_count());
  }

  const Triple& value(ValueId id) const { return values_[id.value]; }

  /// False where the budget ends first.
  bool run(std::span<const Step> steps, StepBudget& budget) {
    uint32_t at = 0;
    while (at < steps.size()) {
      if (budget.left == 0) return false;
      --budget.left;
      at = run_step(steps[at], at);
    }
    return true;
  }

 private:
  /// A reduction under way.
  struct Loop {
    double variable = 0;
    uint32_t remaining = 0;
  };

  /// The step to go on with.
  uint32_t run_step(const Step& step, uint32_t at) {
    switch (step.kind) {
      case Step::Kind::Compute:
        values_[step.value.value] = compute(step.value);
        return at + 1;
      case Step::Kind::IfTrue:
        return operand(step.value, 0)[0] != 0 ? at + 1 : step.target;
      case Step::Kind::IfFalse:
        return operand(step.value, 0)[0] == 0 ? at + 1 : step.target;
      case Step::Kind::BeginLoop:
        return begin_loop(step.value) ? at + 1 : step.target;
      case Step::Kind::EndLoop:
        return end_loop(step.value) ? step.target : at + 1;
    }
    return at + 1;
  }

  const Triple& operand(ValueId id, uint32_t i) const { return values_[graph_.operand(id, i).value]; }

  /// Whether the body is to be evaluated.
  bool begin_loop(ValueId id) {
    const ir::Value& v = graph_.at(id);
    const double first = operand(id, 0)[0];
    const double last = operand(id, 1)[0];
    Triple& result = values_[id.value];
    result = spread(v.op == Op::Sum ? 0 : 1);
    if (!is_bound(first) || !is_bound(last) || last - first >= kMaxIterations) {
      result = spread(kNan);
      return false;
    }
    if (last < first) return false;
    loops_[v.index] = {.variable = first, .remaining = static_cast<uint32_t>(last - first) + 1};
    return true;
  }

  /// Whether the body is to be evaluated once more.
  bool end_loop(ValueId id) {
    const ir::Value& v = graph_.at(id);
    Loop& loop = loops_[v.index];
    Triple& result = values_[id.value];
    const Triple& body = operand(id, 2);
    result = v.op == Op::Sum ? map(std::plus<>{}, result, body) : map(std::multiplies<>{}, result, body);
    if (--loop.remaining == 0) return false;
    if (++iterations_ >= kMaxTotalIterations) {
      result = spread(kNan);
      return false;
    }
    loop.variable += 1;
    return true;
  }

  Triple compute(ValueId id) const {
    const ir::Value& v = graph_.at(id);
    const auto a = [&]() -> const Triple& { return operand(id, 0); };
    const auto b = [&]() -> const Triple& { return operand(id, 1); };
    const auto x = [&] { return a()[0]; };
    const auto y = [&] { return b()[0]; };
    switch (v.op) {
      case Op::Constant:
        return spread(v.constant);
      case Op::Parameter:
        require(v.index < parameters_.size(), "a parameter without a value");
        return is_triple(v.type) ? parameters_[v.index] : spread(parameters_[v.index][0]);
      case Op::Convention:
        return convention(id);
      case Op::BoundVariable:
        return spread(loops_[v.index].variable);
      case Op::MakeVector:
        return {x(), y(), operand(id, 2)[0]};
      case Op::Component:
        return spread(a()[v.index]);
      case Op::Select:
        return x() != 0 ? b() : operand(id, 2);
      case Op::Less:
        return spread(x() < y());
      case Op::LessEqual:
        return spread(x() <= y());
      case Op::Equal:
        return spread(x() == y());
      case Op::And:
        return spread(x() != 0 && y() != 0);
      case Op::Or:
        return spread(x() != 0 || y() != 0);
      case Op::Not:
        return spread(x() == 0);
      case Op::Dot:
        return spread(dot(a(), b()));
      case Op::Cross:
        return cross(a(), b());
      case Op::Negate:
        return {-a()[0], -a()[1], -a()[2]};
      case Op::Add:
        return map(std::plus<>{}, a(), b());
      case Op::Subtract:
        return map(std::minus<>{}, a(), b());
      case Op::Multiply:
        return map(std::multiplies<>{}, a(), b());
      case Op::Divide:
        return map(std::divides<>{}, a(), b());
      case Op::Min:
        return by_component(v, minimum, a(), b());
      case Op::Max:
        return by_component(v, maximum, a(), b());
      case Op::Power:
        return by_component(v, power, a(), b());
      case Op::Root:
        return by_component(v, root, a(), b());
      case Op::Sqrt:
        return by_component(v, [](double component) { return std::sqrt(component); }, a());
      case Op::Exp:
        return by_component(v, [](double component) { return std::exp(component); }, a());
      case Op::Ln:
        return by_component(v, [](double component) { return std::log(component); }, a());
      case Op::Sin:
        return by_component(v, [](double component) { return std::sin(component); }, a());
      case Op::Cos:
        return by_component(v, [](double component) { return std::cos(component); }, a());
      case Op::Tan:
        return by_component(v, [](double component) { return std::tan(component); }, a());
      case Op::Arcsin:
        return by_component(v, arcsin, a());
      case Op::Arccos:
        return by_component(v, arccos, a());
      case Op::Arctan:
        return by_component(v, [](double component) { return std::atan(component); }, a());
      case Op::Arctan2:
        return spread(arctan2(x(), y()));
      case Op::Sinh:
        return by_component(v, [](double component) { return std::sinh(component); }, a());
      case Op::Cosh:
        return by_component(v, [](double component) { return std::cosh(component); }, a());
      case Op::Tanh:
        return by_component(v, [](double component) { return std::tanh(component); }, a());
      case Op::Reference:
      case Op::Formal:
      case Op::Call:
      case Op::Sum:
      case Op::Product:
      case Op::Integral:
      case Op::Derivative:
      case Op::MakeMatrix:
      case Op::Entry:
        break;
    }
    throw InternalError("an op that flattening or the schedule should have taken away");
  }

  Triple convention(ValueId id) const {
    const auto a = [&]() -> const Triple& { return operand(id, 0); };
    const auto b = [&]() -> const Triple& { return operand(id, 1); };
    switch (static_cast<Convention>(graph_.at(id).index)) {
      case Convention::OmegaI:
        return geometry_.light;
      case Convention::OmegaO:
        return geometry_.view;
      case Convention::Normal:
        return geometry_.normal;
      case Convention::Tangent:
        return geometry_.tangent;
      case Convention::Bitangent:
        return geometry_.bitangent;
      case Convention::Half:
        return normalised_sum(a(), b());
      case Convention::ThetaI:
      case Convention::ThetaO:
      case Convention::ThetaH:
      case Convention::ThetaD:
        return spread(angle_between(a(), b()));
      case Convention::PhiI:
      case Convention::PhiO:
      case Convention::PhiH: {
        const Triple& direction = operand(id, 2);
        return spread(arctan2(dot(direction, b()), dot(direction, a())));
      }
      case Convention::Pi:
        return spread(kPi);
      case Convention::Epsilon:
        return spread(kEpsilon);
      case Convention::Euler:
        return spread(kEuler);
    }
    throw InternalError("a convention that is not in the table");
  }

  const ir::Graph& graph_;
  const Geometry& geometry_;
  std::span<const Triple> parameters_;
  std::vector<Triple> values_;
  std::vector<Loop> loops_;  ///< by binder
  uint32_t iterations_ = 0;  ///< of all loops
};

/// A convention that is made of others must have them as operands, or the walk would read beyond its own.
void require_operands(const ir::Graph& graph) {
  for (const ir::Value& v : graph.values()) {
    if (v.op != Op::Convention) continue;
    const ConventionEntry& entry = convention_entry(static_cast<Convention>(v.index));
    require(v.operand_count == entry.operands.size(), "a convention without its operands");
  }
}

}  // namespace

ReferenceEvaluator::ReferenceEvaluator(ir::Graph graph) : graph_(std::move(graph)), schedule_(schedule(graph_)) {
  require_operands(graph_);
}

Triple ReferenceEvaluator::evaluate(const Geometry& geometry, std::span<const Triple> parameters,
                                    std::size_t root) const {
  StepBudget unlimited{UINT64_MAX};
  return evaluate(geometry, parameters, root, unlimited).value();
}

std::optional<Triple> ReferenceEvaluator::evaluate(const Geometry& geometry, std::span<const Triple> parameters,
                                                   std::size_t root, StepBudget& budget) const {
  require(root < graph_.roots.size(), "a root that the graph does not have");
  Walk walk(graph_, geometry, parameters);
  if (!walk.run(std::span(schedule_.steps).first(schedule_.root_end[root]), budget)) return std::nullopt;
  return walk.value(graph_.roots[root]);
}

std::optional<std::vector<Triple>> ReferenceEvaluator::evaluate_all(const Geometry& geometry,
                                                                    std::span<const Triple> parameters,
                                                                    StepBudget& budget) const {
  Walk walk(graph_, geometry, parameters);
  if (!walk.run(schedule_.steps, budget)) return std::nullopt;
  std::vector<Triple> values;
  values.reserve(graph_.roots.size());
  for (const ir::ValueId root : graph_.roots) values.push_back(walk.value(root));
  return values;
}

}  // namespace texbrdf::eval

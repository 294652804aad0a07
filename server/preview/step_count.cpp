#include "preview/step_count.h"

#include <cstdint>
#include <optional>
#include <vector>

#include "eval/limits.h"

namespace texbrdf::preview {
namespace {

class StepCount {
 public:
  StepCount(const ir::Graph& graph, std::span<const eval::Triple> parameters)
      : graph_(graph), parameters_(parameters), iterations_(graph.binder_count(), 1.0) {}

  double count() {
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      const ir::Value& value = graph_.at({i});
      if (is_reduction(value)) iterations_[value.index] = iterations({i});
    }
    double steps = 0;
    for (const ir::Value& value : graph_.values()) {
      steps += repetitions(value.binders) * (is_reduction(value) ? iterations_[value.index] : 1);
    }
    return steps;
  }

 private:
  static bool is_reduction(const ir::Value& value) { return value.op == ir::Op::Sum || value.op == ir::Op::Product; }

  double iterations(ir::ValueId reduction) const {
    const std::optional<double> first = number(graph_.operand(reduction, 0));
    const std::optional<double> last = number(graph_.operand(reduction, 1));
    if (!first || !last) return eval::kMaxIterations;
    const double count = *last - *first + 1;
    return count >= 1 && count <= eval::kMaxIterations ? count : 1;  // another is empty, or NaN at once
  }

  std::optional<double> number(ir::ValueId id) const {
    const ir::Value& value = graph_.at(id);
    if (value.op == ir::Op::Constant) return value.constant;
    if (value.op == ir::Op::Parameter) return parameters_[value.index][0];
    return std::nullopt;
  }

  double repetitions(ir::BinderSet binders) const {
    double product = 1;
    for (uint32_t binder = 0; binder < iterations_.size(); ++binder) {
      if ((binders >> binder & 1) != 0) product *= iterations_[binder];
    }
    return product;
  }

  const ir::Graph& graph_;
  std::span<const eval::Triple> parameters_;
  std::vector<double> iterations_;  ///< by binder
};

}  // namespace

double most_steps(const ir::Graph& graph, std::span<const eval::Triple> parameters) {
  return StepCount(graph, parameters).count();
}

}  // namespace texbrdf::preview

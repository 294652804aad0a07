#include "features/integral_error.h"

#include <algorithm>
#include <cmath>

#include "eval/compile.h"
#include "features/sample_geometries.h"

namespace texbrdf::features {
namespace {

constexpr double kWorthTelling = 1e-4;
constexpr uint64_t kMostSteps = 6'000'000;

std::optional<std::vector<eval::Triple>> values_of(const Snapshot& snapshot, std::string_view root,
                                                   ir::Fineness fineness, const std::stop_token& stop) {
  ir::LinkOptions options;
  options.fineness = fineness;
  const Result<ir::Program> program = snapshot.program(root, options);
  if (!program) return std::nullopt;
  const Result<eval::CompiledModel> model = eval::compile(*program);
  if (!model) return std::nullopt;
  const eval::ReferenceEvaluator evaluator(model->optimised);
  eval::StepBudget budget{kMostSteps};
  std::vector<eval::Triple> values;
  for (const eval::Geometry& geometry : sample_geometries()) {
    if (stop.stop_requested()) return std::nullopt;
    const std::optional<eval::Triple> value = evaluator.evaluate(geometry, model->parameters, 0, budget);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

double largest_difference(const std::vector<eval::Triple>& exact, const std::vector<eval::Triple>& coarse) {
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t c = 0; c < exact[i].size(); ++c) {
      const double difference = std::abs(exact[i][c] - coarse[i][c]);
      if (difference > 0) largest = std::max(largest, difference / std::abs(exact[i][c]));
    }
  }
  return largest;
}

}  // namespace

std::optional<double> integral_error(const Snapshot& snapshot, std::string_view root, const std::stop_token& stop) {
  const auto exact = values_of(snapshot, root, ir::Fineness::Full, stop);
  if (!exact) return std::nullopt;
  const auto coarse = values_of(snapshot, root, ir::Fineness::Half, stop);
  if (!coarse) return std::nullopt;
  const double difference = largest_difference(*exact, *coarse);
  return difference > kWorthTelling ? std::optional(difference) : std::nullopt;
}

}  // namespace texbrdf::features

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "eval/schedule.h"
#include "ir/graph.h"

namespace texbrdf::eval {

/// Where a BRDF is asked for. All unit vectors of one right-handed frame (world or tangent, the caller's choice).
struct Geometry {
  std::array<double, 3> light;  ///< L, omega_i: from the surface towards the light
  std::array<double, 3> view;   ///< V, omega_o: towards the viewer
  std::array<double, 3> normal{0, 0, 1};
  std::array<double, 3> tangent{1, 0, 0};
  std::array<double, 3> bitangent{0, 1, 0};
};

using Triple = std::array<double, 3>;

/// How many values may still be computed, those of a reduction's body once for each iteration: what bounds the time of
/// an evaluation that somebody waits for.
struct StepBudget {
  uint64_t left = 0;
};

/// The reference meaning of the language: double precision, one geometry at a time, straight from the graph.
/// `graph` is flattened (ir::flatten), with or without passes; conventions of any kind are understood.
/// `parameters[i]` is the value of Op::Parameter i. A real root gives the same number three times.
///
/// Where IEEE arithmetic leaves a choice (real_functions.h):
/// - Power: x^0 = 1 for every x, NaN included. A zero counts as positive whatever its sign bit: to a negative power it
/// is
///   +infinity. A NaN exponent gives NaN; an infinite exponent is no integer. Root with index 0 is NaN.
/// - Min and Max give NaN if either operand is NaN. A comparison with NaN is false.
/// - arccos and arcsin accept 1e-6 beyond ±1. The angle of arctan2 is in (−π, π], that of two zeros is 0.
/// - Select evaluates only the branch that is taken; Sum and Product only evaluate what their range asks for.
/// - Sum and Product go up from the first to the last bound by ones. NaN where a bound is no integer or beyond
///   ±kMaxBound, or where the range has more than kMaxIterations; else 0 or 1 for an empty range (limits.h).
///
/// Immutable after construction: threads may share it.
class ReferenceEvaluator {
 public:
  explicit ReferenceEvaluator(ir::Graph graph);
  /// The value of roots[root]; the raw value, nothing is clamped.
  Triple evaluate(const Geometry& geometry, std::span<const Triple> parameters, std::size_t root = 0) const;
  /// The same; nothing where the budget ends first.
  std::optional<Triple> evaluate(const Geometry& geometry, std::span<const Triple> parameters, std::size_t root,
                                 StepBudget& budget) const;
  /// The values of all roots, in order.
  std::optional<std::vector<Triple>> evaluate_all(const Geometry& geometry, std::span<const Triple> parameters,
                                                  StepBudget& budget) const;

 private:
  ir::Graph graph_;
  Schedule schedule_;
};

}  // namespace texbrdf::eval

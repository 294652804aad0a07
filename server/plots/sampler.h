#pragma once

#include <cstdint>
#include <optional>

#include "plots/samples.h"

namespace texbrdf::plots {

/// Asks a model as long as its steps last.
class Sampler {
 public:
  Sampler(const preview::ExactModel& model, uint64_t steps) : model_(model), budget_{steps} {}

  /// Times `cosine`. Nothing below the horizon and once the steps are used up.
  Sample value(const eval::Geometry& geometry, double cosine = 1);
  bool is_exhausted() const { return is_exhausted_; }
  uint64_t steps_left() const { return budget_.left; }

  /// What one value costs, by asking for one.
  uint64_t cost_of(const eval::Geometry& geometry);

 private:
  const preview::ExactModel& model_;
  eval::StepBudget budget_;
  bool is_exhausted_ = false;
};

}  // namespace texbrdf::plots

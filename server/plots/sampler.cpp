#include "plots/sampler.h"

#include "plots/directions.h"

namespace texbrdf::plots {

Sample Sampler::value(const eval::Geometry& geometry, double cosine) {
  if (!is_above_horizon(geometry)) return std::nullopt;
  Sample value = model_.value(geometry, budget_);
  if (!value) {
    is_exhausted_ = true;
    return std::nullopt;
  }
  if (cosine != 1) {
    for (double& channel : *value) channel *= cosine;
  }
  return value;
}

uint64_t Sampler::cost_of(const eval::Geometry& geometry) {
  const uint64_t before = budget_.left;
  if (!model_.value(geometry, budget_)) is_exhausted_ = true;
  return before - budget_.left;
}

}  // namespace texbrdf::plots

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "eval/batch.h"
#include "eval/evaluate.h"
#include "ir/graph.h"

namespace texbrdf::eval {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// A way to run a batch: an instruction set that this machine has, with SLEEF or with the C library.
struct Backend {
  InstructionSet set;
  const ElementaryFunctions* functions;
  std::string name;
};

inline std::vector<Backend> backends() {
  std::vector<Backend> all;
  for (const InstructionSet set : kInstructionSets) {
    if (!has_instruction_set(set)) continue;
    const std::string name(instruction_set_name(set));
    all.push_back({set, &load_elementary_functions(set), name});
    all.push_back({set, &scalar_elementary_functions(), name + " without SLEEF"});
  }
  return all;
}

/// Geometries as a GeometryBatch wants them.
class GeometryArrays {
 public:
  explicit GeometryArrays(const std::vector<Geometry>& geometries) : arrays_(15), count_(geometries.size()) {
    for (const Geometry& g : geometries) {
      std::size_t next = 0;
      for (const auto& vector : {g.light, g.view, g.normal, g.tangent, g.bitangent}) {
        for (const double x : vector) arrays_[next++].push_back(static_cast<float>(x));
      }
    }
  }

  GeometryBatch batch() const {
    const auto vector = [this](std::size_t i) {
      return std::array<const float*, 3>{arrays_[i].data(), arrays_[i + 1].data(), arrays_[i + 2].data()};
    };
    return {.count = count_,
            .light = vector(0),
            .view = vector(3),
            .normal = vector(6),
            .tangent = vector(9),
            .bitangent = vector(12)};
  }

 private:
  std::vector<std::vector<float>> arrays_;
  std::size_t count_;
};

inline std::vector<Triple> evaluate_batch(const BatchEvaluator& evaluator, const std::vector<Geometry>& geometries,
                                          const std::vector<Triple>& parameters = {}, std::size_t root = 0) {
  const GeometryArrays arrays(geometries);
  std::vector<float> red(geometries.size()), green(geometries.size()), blue(geometries.size());
  evaluator.evaluate(arrays.batch(), parameters, {red.data(), green.data(), blue.data()}, root);
  std::vector<Triple> result;
  for (std::size_t i = 0; i < geometries.size(); ++i) result.push_back({red[i], green[i], blue[i]});
  return result;
}

/// Equal, both NaN, or within `relative` of the expected value (`absolute` near zero).
inline bool is_close(double actual, double expected, double relative, double absolute = 0) {
  if (std::isnan(expected) || std::isnan(actual)) return std::isnan(expected) && std::isnan(actual);
  if (actual == expected) return true;
  return std::abs(actual - expected) <= relative * std::abs(expected) + absolute;
}

}  // namespace texbrdf::eval

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "eval/elementary_functions.h"
#include "eval/evaluate.h"
#include "eval/instruction_set.h"
#include "ir/graph.h"

namespace texbrdf::eval {

/// Geometries as structure of arrays: `count` values behind each pointer, no alignment needed. Pointers of inputs that
/// the graph does not use may be null.
struct GeometryBatch {
  std::size_t count = 0;
  std::array<const float*, 3> light;
  std::array<const float*, 3> view;
  std::array<const float*, 3> normal;
  std::array<const float*, 3> tangent;
  std::array<const float*, 3> bitangent;
};

struct Tape;

/// Single precision in batches of 128 lanes: what draws previews. The tape has regions (loops, lane masks), so a branch
/// that a lane does not take cannot leak NaN into it. What does not depend on the geometry is computed once for all
/// batches. The operations mean what they mean to the ReferenceEvaluator. + - * / sqrt min max and the choices between
/// values are the same on every instruction set; elementary functions are within 1 ulp where SLEEF is installed.
/// Immutable after construction: threads may share it.
class BatchEvaluator {
 public:
  /// `graph`: flattened, after ir::evaluation_passes (it also works without, only slower).
  explicit BatchEvaluator(const ir::Graph& graph, InstructionSet set = best_instruction_set());
  BatchEvaluator(const ir::Graph& graph, InstructionSet set, const ElementaryFunctions& functions);
  BatchEvaluator(BatchEvaluator&&) noexcept;
  BatchEvaluator& operator=(BatchEvaluator&&) noexcept;
  ~BatchEvaluator();

  /// Writes roots[root]: red, green, blue (equal for a real) of each geometry; linear, raw.
  void evaluate(const GeometryBatch& geometry, std::span<const Triple> parameters, std::array<float*, 3> out,
                std::size_t root = 0) const;

 private:
  std::unique_ptr<const Tape> tape_;
  InstructionSet set_;
  const ElementaryFunctions* functions_;
};

}  // namespace texbrdf::eval

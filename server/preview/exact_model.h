#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "eval/evaluate.h"
#include "ir/program.h"
#include "source/result.h"

namespace texbrdf::preview {

/// What of a program has a value wherever the BRDF has one: the BRDF, a definition without arguments, a parameter.
struct Quantity {
  enum class Kind : uint8_t { Brdf, Definition, Parameter };
  Kind kind = Kind::Definition;
  std::string name;        ///< canonical
  Type type = Type::Real;  ///< Colour for the BRDF and parameters, Vector for other triples
  uint32_t index = 0;      ///< of Program::parameters or Program::definitions
};

/// In order of need: a quantity stands behind those that it needs; the BRDF is the last.
std::vector<Quantity> quantities(const ir::Program& program);

/// A program ready for the reference evaluator: what the numbers beside a picture come from. Immutable.
class ExactModel {
 public:
  /// Fails where the equations are so large that values at a point would have to be waited for.
  static Result<ExactModel> compile(ir::Program program);

  const ir::Program& program() const { return program_; }
  std::span<const Quantity> quantities() const { return quantities_; }
  const Quantity& brdf() const { return quantities_.back(); }
  /// nullptr where nothing of the name has a value.
  const Quantity* find(std::string_view name) const;

  /// Of the BRDF, as `texbrdf eval` gives it. Nothing where the budget ends first, here and below.
  std::optional<eval::Triple> value(const eval::Geometry& geometry, eval::StepBudget& budget) const;
  std::optional<eval::Triple> value(const Quantity& quantity, const eval::Geometry& geometry,
                                    eval::StepBudget& budget) const;
  /// Of all quantities, in their order.
  std::optional<std::vector<eval::Triple>> values(const eval::Geometry& geometry, eval::StepBudget& budget) const;

 private:
  ExactModel(ir::Program program, ir::Graph brdf, ir::Graph all);

  ir::Program program_;
  std::vector<eval::Triple> parameters_;
  std::vector<Quantity> quantities_;
  std::vector<std::size_t> roots_;  ///< of `all_`, by Program::definitions
  eval::ReferenceEvaluator brdf_;   ///< evaluates nothing that the BRDF does not need at the point
  eval::ReferenceEvaluator all_;
};

}  // namespace texbrdf::preview

#pragma once

#include <vector>

#include "eval/evaluate.h"
#include "ir/graph.h"
#include "ir/program.h"
#include "source/result.h"

namespace texbrdf::eval {

/// A program on its way to the evaluators: the one path that commands and previews take.
struct CompiledModel {
  ir::Graph unoptimised;           ///< for the ReferenceEvaluator, where results are held against the definition
  ir::Graph optimised;             ///< after ir::evaluation_passes, for the BatchEvaluator
  std::vector<Triple> parameters;  ///< values of Program::parameters, a real three times
};

/// Fails where flattening does.
Result<CompiledModel> compile(const ir::Program& program);

/// The values that evaluators take for the parameters of a program.
std::vector<Triple> parameter_values(const ir::Program& program);

}  // namespace texbrdf::eval

#pragma once

#include <array>
#include <string>

#include "emit/emit.h"
#include "eval/batch.h"
#include "eval/compile.h"
#include "eval/evaluate.h"
#include "ir/print.h"
#include "ir/validate.h"
#include "source/internal_error.h"

namespace texbrdf::test {

inline constexpr uint32_t kMaxEvaluated = 20'000;  // values; more takes long and shows nothing new

inline void evaluate(const ir::Program& program) {
  const Result<eval::CompiledModel> model = eval::compile(program);
  if (!model || model->unoptimised.size() > kMaxEvaluated) return;
  const eval::Geometry geometry{.light = {0.6, 0, 0.8}, .view = {0, -0.28, 0.96}};
  eval::ReferenceEvaluator(model->unoptimised).evaluate(geometry, model->parameters);

  const std::array<float, 9> frame = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<float, 6> directions = {0.6F, 0, 0.8F, 0, -0.28F, 0.96F};
  const auto vector = [](const float* at) { return std::array{at, at + 1, at + 2}; };
  const eval::GeometryBatch batch = {.count = 1,
                                     .light = vector(directions.data()),
                                     .view = vector(directions.data() + 3),
                                     .normal = vector(frame.data() + 6),
                                     .tangent = vector(frame.data()),
                                     .bitangent = vector(frame.data() + 3)};
  for (const eval::InstructionSet set : eval::kInstructionSets) {
    if (!eval::has_instruction_set(set)) continue;
    std::array<float, 3> value{};
    eval::BatchEvaluator(model->optimised, set).evaluate(batch, model->parameters, {&value[0], &value[1], &value[2]});
  }
}

inline void emit_all(const ir::Program& program) {
  for (const emit::Target& target : emit::targets()) {
    for (const auto style : {emit::ParameterStyle::Constant, emit::ParameterStyle::Uniform}) {
      const Result<emit::EmittedCode> code = target.emit(program, {.parameters = style});
      require(!code || !code->text.empty(), "a target writes nothing");
    }
  }
  require(emit::parameter_identifiers(program).size() == program.parameters.size(), "a parameter has no identifier");
}

/// All that can be done with a program; it has to be right.
inline void exercise(const ir::Program& program) {
  require(!ir::find_fault(program), "a program is broken");
  ir::print_program(program);
  evaluate(program);
  emit_all(program);
}

}  // namespace texbrdf::test

#include "eval/compile.h"

#include <utility>

#include "ir/passes/passes.h"

namespace texbrdf::eval {

std::vector<Triple> parameter_values(const ir::Program& program) {
  std::vector<Triple> values;
  values.reserve(program.parameters.size());
  for (const ir::Parameter& parameter : program.parameters) {
    const double first = parameter.value[0];
    values.push_back(is_triple(parameter.type) ? parameter.value : Triple{first, first, first});
  }
  return values;
}

Result<CompiledModel> compile(const ir::Program& program) {
  Result<ir::Graph> flat = ir::flatten(program);
  if (!flat) return Failure{flat.error()};
  ir::Graph optimised = ir::run_passes(*flat, ir::evaluation_passes());
  return CompiledModel{
      .unoptimised = std::move(*flat), .optimised = std::move(optimised), .parameters = parameter_values(program)};
}

}  // namespace texbrdf::eval

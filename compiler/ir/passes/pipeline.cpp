#include <array>
#include <string>

#include "ir/passes/passes.h"
#include "ir/validate.h"

namespace texbrdf::ir {

namespace {

// fold_constants comes before expand_powers, which wants exponents such as {-4} and \frac{1}{2} as one constant.
constexpr std::array kEvaluationPasses = {
    Pass{"angles_to_dot_products", angles_to_dot_products},
    Pass{"expand_conventions", expand_conventions},
    Pass{"fold_constants", fold_constants},
    Pass{"expand_powers", expand_powers},
    Pass{"share_common_subexpressions", share_common_subexpressions},
    Pass{"remove_dead_values", remove_dead_values},
};

// Powers stay powers: generated code reads `pow5(x)`, not a product of products.
constexpr std::array kEmissionPasses = {
    Pass{"angles_to_dot_products", angles_to_dot_products},
    Pass{"expand_shadowed_conventions", expand_shadowed_conventions},
    Pass{"fold_constants", fold_constants},
    Pass{"share_common_subexpressions", share_common_subexpressions},
    Pass{"remove_dead_values", remove_dead_values},
};

#ifdef NDEBUG
constexpr bool kValidate = false;
#else
constexpr bool kValidate = true;
#endif

}  // namespace

std::span<const Pass> evaluation_passes() {
  return kEvaluationPasses;
}

std::span<const Pass> emission_passes() {
  return kEmissionPasses;
}

Graph run_passes(Graph graph, std::span<const Pass> passes) {
  for (const Pass& pass : passes) {
    graph = pass.run(graph);
    if (kValidate) validate(graph, std::string(pass.name).c_str());
  }
  return graph;
}

Program run_passes(Program program, std::span<const Pass> passes) {
  for (ProgramDefinition& definition : program.definitions) {
    definition.graph = run_passes(std::move(definition.graph), passes);
  }
  return program;
}

}  // namespace texbrdf::ir

#include "preview/scene.h"

#include <algorithm>

namespace texbrdf::preview {
namespace {

/// A value whose parameter has gone from the document, or has become a colour, is left out.
void set_values(ir::Program& program, const std::map<std::string, std::vector<double>>& values) {
  for (ir::Parameter& parameter : program.parameters) {
    const auto value = values.find(parameter.canonical);
    if (value == values.end() || value->second.size() != type_components(parameter.type)) continue;
    std::ranges::copy(value->second, parameter.value.begin());
  }
}

}  // namespace

Result<ir::Program> scene_program(const Scene& scene) {
  Result<ir::Program> program = scene.snapshot.program(scene.root);
  if (program) set_values(*program, scene.values);
  return program;
}

}  // namespace texbrdf::preview

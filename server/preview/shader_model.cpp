#include "preview/shader_model.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "emit/emit.h"

namespace texbrdf::preview {

namespace {

render::Uniform uniform_of(const ir::Parameter& parameter, std::string name) {
  render::Uniform uniform{std::move(name), type_components(parameter.type), {}};
  for (std::size_t c = 0; c < 3; ++c) uniform.value[c] = static_cast<float>(parameter.value[c]);
  return uniform;
}

}  // namespace

Result<render::ShaderModel> shader_model(const ir::Program& program) {
  const emit::Target* glsl = emit::find_target("glsl");
  require(glsl != nullptr, "there is no target glsl");
  Result<emit::EmittedCode> source = glsl->emit(program, {.parameters = emit::ParameterStyle::Uniform});
  if (!source) return Failure{source.error()};
  render::ShaderModel model{std::move(source->text), {}};
  const std::vector<std::string> names = emit::parameter_identifiers(program);
  for (std::size_t i = 0; i < program.parameters.size(); ++i) {
    model.uniforms.push_back(uniform_of(program.parameters[i], names[i]));
  }
  return model;
}

}  // namespace texbrdf::preview

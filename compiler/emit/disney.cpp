#include "emit/disney.h"

#include "emit/glsl_code.h"
#include "emit/number.h"

namespace texbrdf::emit {
namespace {

std::string parameter_line(const ir::Parameter& parameter, const std::string& name) {
  if (!is_triple(parameter.type))
    return "float " + name + " " + plain_number(parameter.minimum) + " " + plain_number(parameter.maximum) + " " +
           plain_number(parameter.value[0]) + "\n";
  std::string line = "color " + name;
  for (double component : parameter.value) line += " " + plain_number(component);
  return line + "\n";
}

}  // namespace

Result<EmittedCode> emit_disney(const ir::Program& program, const EmitOptions& /*options*/) {
  Result<GlslCode> code = write_glsl(program, kExplorerDialect, ParameterScope::Everywhere);
  if (!code) return Failure{code.error()};
  CodeText out;
  out.append("analytic\n\n::begin parameters\n");
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    out.append_line(parameter_line(program.parameters[i], code->parameters[i]), program.parameters[i].id);
  out.append("::end parameters\n\n::begin shader\n\n");
  out.append(code->functions);
  out.append("\n::end shader\n");
  return out.take();
}

}  // namespace texbrdf::emit

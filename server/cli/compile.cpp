#include <fmt/core.h>

#include <memory>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/subcommands.h"
#include "emit/emit.h"

namespace texbrdf::cli {
namespace {

struct CompileOptions {
  ModelOptions model;
  std::string target = "disney";
  emit::EmitOptions emit;
  std::string output = "-";
};

ExitCode compile(const CompileOptions& options) {
  const auto loaded = load_model(options.model);
  if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
  const Model& model = std::get<Model>(loaded);
  const Result<emit::EmittedCode> code = emit::find_target(options.target)->emit(model.program, options.emit);
  if (!code) {
    print_message(code.error());
    return ExitCode::DocumentHasErrors;
  }
  if (const auto failure = write_output(options.output, code->text)) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  return model.exit_code();
}

}  // namespace

Subcommand add_compile(CLI::App& program) {
  const auto options = std::make_shared<CompileOptions>();
  CLI::App* const arguments = program.add_subcommand("compile", "Translate the BRDF to shader code");
  add_model_options(*arguments, options->model);

  std::vector<std::string> names;
  std::string descriptions = "what to write:";
  for (const emit::Target& target : emit::targets()) {
    names.emplace_back(target.name);
    descriptions += fmt::format(" {} ({})", target.name, target.description);
  }
  arguments->add_option("--target", options->target, descriptions)->check(CLI::IsMember(names))->capture_default_str();

  const std::map<std::string, emit::ParameterStyle> styles{{"constant", emit::ParameterStyle::Constant},
                                                           {"uniform", emit::ParameterStyle::Uniform}};
  arguments->add_option("--parameters", options->emit.parameters, "how glsl writes parameters: constant, uniform")
      ->transform(CLI::CheckedTransformer(styles).description(""))
      ->type_name("STYLE");
  arguments->add_option("-o,--output", options->output, "the file to write, - for standard output")->type_name("OUT");
  return {arguments, [options] { return compile(*options); }};
}

}  // namespace texbrdf::cli

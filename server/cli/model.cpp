#include "cli/model.h"

#include <fmt/core.h>

#include <charconv>
#include <span>

#include "cli/files.h"
#include "cli/messages.h"
#include "files/follow_includes.h"
#include "semantics/names.h"
#include "syntax/block_scanner.h"
#include "syntax/parsed_block.h"

namespace texbrdf::cli {
namespace {

Result<ParameterValues> read_settings(const std::vector<std::string>& settings) {
  ParameterValues values;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const std::optional<std::string> canonical = canonical_name(name);
    if (equals == std::string::npos || !canonical) {
      return Failure{fmt::format("--set takes NAME=VALUE, got '{}'", setting)};
    }
    const auto numbers = read_numbers(std::string_view(setting).substr(equals + 1));
    if (!numbers) {
      return Failure{fmt::format("--set {}: a value is a number or three with commas between, got '{}'", name,
                                 setting.substr(equals + 1))};
    }
    values[*canonical] = *numbers;
  }
  return values;
}

}  // namespace

std::optional<std::vector<double>> read_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = text.substr(0, text.find(','));
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    numbers.push_back(number);
    if (word.size() == text.size()) return numbers;
    text.remove_prefix(word.size() + 1);
  }
}

std::variant<NamedDocument, ExitCode> read_document(const std::string& path) {
  Result<std::string> bytes = read_input(path);
  if (!bytes) {
    print_message(bytes.error());
    return ExitCode::BadUsage;
  }
  NamedDocument named{{}, {}, Document(*bytes, language_of_path(path))};
  const bool is_standard_input = path == "-";
  const std::string folder = files::real_path(".");
  named.paths = {is_standard_input ? folder + "/-" : files::real_path(path)};
  files::DiskFiles disk;
  files::follow_includes(named.document, named.paths, disk);
  named.file_names = {input_name(path)};
  for (const std::string& included : std::span(named.paths).subspan(1)) {
    const bool is_here = files::is_below(included, folder) && !path.starts_with('/');
    named.file_names.push_back(is_here ? included.substr(folder.size() + 1) : included);
  }
  return named;
}

void add_root_option(CLI::App& arguments, std::string& root) {
  arguments
      .add_option(
          "--root", root,
          "the definition that is the BRDF; else what the document says (% texbrdf: root = NAME), or the one of f, f_r, "
          "f_s, f_{...} that the others serve")
      ->type_name("NAME");
}

std::optional<std::string> root_option(const std::string& typed) {
  if (typed.empty()) return std::string();
  std::optional<std::string> root = canonical_name(typed);
  if (!root) print_message(fmt::format("--root takes a name, got '{}'", typed));
  return root;
}

void add_model_options(CLI::App& arguments, ModelOptions& options) {
  arguments.add_option("FILE", options.file, "a LaTeX document, - for standard input")->required();
  add_model_choice(arguments, options);
}

void add_model_choice(CLI::App& arguments, ModelOptions& options) {
  add_root_option(arguments, options.root);
  arguments.add_option("--set", options.settings, "another value for a parameter: m=0.2, \\rho_d=0.1,0.2,0.3")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

std::variant<ModelSource, ExitCode> load_model_source(const ModelOptions& options) {
  const std::optional<std::string> root = root_option(options.root);
  if (!root) return ExitCode::BadUsage;
  Result<ParameterValues> values = read_settings(options.settings);
  if (!values) {
    print_message(values.error());
    return ExitCode::BadUsage;
  }
  auto read = read_document(options.file);
  if (const auto* failed = std::get_if<ExitCode>(&read)) return *failed;
  NamedDocument& named = std::get<NamedDocument>(read);

  const Snapshot& snapshot = named.document.snapshot();
  const std::vector<Diagnostic> diagnostics = snapshot.diagnostics(*root);
  report_errors_and_warnings(snapshot, diagnostics, named.file_names);
  if (const Result<ir::Program> plain = snapshot.program(*root); !plain) {
    print_message(fmt::format("{}: {}", named.file_names.front(), plain.error()));
    return ExitCode::DocumentHasErrors;
  }
  return ModelSource{std::move(named), *root, *std::move(values), has_error(diagnostics)};
}

Result<ir::Program> ModelSource::program(const ParameterValues& others) {
  ir::LinkOptions options{.values = values};
  for (const auto& [name, value] : others) options.values[name] = value;
  return named.document.snapshot().program(root, options);
}

std::variant<Model, ExitCode> load_model(const ModelOptions& options) {
  auto loaded = load_model_source(options);
  if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
  ModelSource& source = std::get<ModelSource>(loaded);
  Result<ir::Program> program = source.program();
  if (!program) {
    print_message(program.error());
    return ExitCode::BadUsage;
  }
  return Model{*std::move(program), source.document_has_errors};
}

}  // namespace texbrdf::cli

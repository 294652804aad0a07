#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <span>

#include "cli/check_scene.h"
#include "cli/files.h"
#include "cli/json_output.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/sarif.h"
#include "cli/subcommands.h"
#include "features/numeric_diagnostics.h"

namespace texbrdf::cli {
namespace {

enum class Format : uint8_t { Text, Json, Sarif };

struct CheckOptions {
  std::vector<std::string> files;
  std::string root;
  Format format = Format::Text;
  std::string output = "-";
};

std::string text_report(std::span<const CheckedFile> files, bool colour) {
  std::string report;
  for (const CheckedFile& file : files) report += terminal_text(*file.snapshot, file.diagnostics, file.names, colour);
  return report;
}

std::string formatted(std::span<const CheckedFile> files, const CheckOptions& options) {
  switch (options.format) {
    case Format::Text:
      return text_report(files, options.output == "-" && wants_colour(STDOUT_FILENO));
    case Format::Json:
      return diagnostics_json(files);
    case Format::Sarif:
      return diagnostics_sarif(files);
  }
  return {};
}

/// Another of the documents includes it: it is checked there. Of those that include each other the first counts.
bool is_included(const std::deque<NamedDocument>& documents, std::size_t index) {
  const auto includes = [&](std::size_t a, std::size_t b) {
    const auto included = std::span(documents[a].paths).subspan(1);
    return std::ranges::find(included, documents[b].paths.front()) != included.end();
  };
  for (std::size_t i = 0; i < documents.size(); ++i) {
    if (i != index && includes(i, index) && (i < index || !includes(index, i))) return true;
  }
  return false;
}

ExitCode check(const CheckOptions& options) {
  const std::optional<std::string> root = root_option(options.root);
  if (!root) return ExitCode::BadUsage;
  if (options.format != Format::Text && std::ranges::any_of(options.files, is_scene_file)) {
    print_message("what is wrong with scenes is told as text only: leave out --format");
    return ExitCode::BadUsage;
  }
  ExitCode exit_code = ExitCode::Fine;
  std::string scenes;
  std::deque<NamedDocument> documents;  // snapshots must stay where they are
  for (const std::string& path : options.files) {
    if (is_scene_file(path)) {
      const CheckedScene scene = check_scene_and_code(path);
      scenes += scene.report;
      exit_code = std::max(exit_code, scene.exit_code);
      continue;
    }
    auto read = read_document(path);
    if (std::holds_alternative<ExitCode>(read)) {
      exit_code = ExitCode::BadUsage;
    } else {
      documents.emplace_back(std::get<NamedDocument>(std::move(read)));
    }
  }
  std::vector<CheckedFile> files;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    if (is_included(documents, i)) continue;
    const Snapshot& snapshot = documents[i].document.snapshot();
    files.push_back({documents[i].file_names, &snapshot, features::all_diagnostics(snapshot, *root)});
    if (has_error(files.back().diagnostics)) exit_code = std::max(exit_code, ExitCode::DocumentHasErrors);
  }
  if (const auto failure = write_output(options.output, formatted(files, options) + scenes)) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  return exit_code;
}

}  // namespace

Subcommand add_check(CLI::App& program) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* const arguments = program.add_subcommand("check", "Report what is wrong with documents");
  arguments->add_option("FILE", options->files, "LaTeX documents and scenes (.json), - for standard input")->required();
  add_root_option(*arguments, options->root);
  const std::map<std::string, Format> formats{{"text", Format::Text}, {"json", Format::Json}, {"sarif", Format::Sarif}};
  arguments->add_option("--format", options->format, "text (for people), json or sarif")
      ->transform(CLI::CheckedTransformer(formats).description(""))
      ->type_name("FORMAT");
  arguments->add_option("-o,--output", options->output, "the file to write, - for standard output")->type_name("OUT");
  return {arguments, [options] { return check(*options); }};
}

}  // namespace texbrdf::cli

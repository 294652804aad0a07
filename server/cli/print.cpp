#include <fmt/core.h>

#include <memory>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/subcommands.h"
#include "syntax/print_source.h"

namespace texbrdf::cli {
namespace {

struct PrintOptions {
  std::string file;
  std::string output = "-";
};

/// Printing needs no names and no types: whether those are right is the business of other commands.
std::vector<Diagnostic> syntax_diagnostics(const Snapshot& snapshot) {
  constexpr int kFirstCodeBeyondSyntax = 3000;
  std::vector<Diagnostic> diagnostics = snapshot.diagnostics();
  std::erase_if(diagnostics, [](const Diagnostic& d) {
    return d.code == Code::MissingRoot || static_cast<int>(d.code) >= kFirstCodeBeyondSyntax;
  });
  return diagnostics;
}

ExitCode print(const PrintOptions& options) {
  auto read = read_document(options.file);
  if (const auto* failed = std::get_if<ExitCode>(&read)) return *failed;
  NamedDocument& named = std::get<NamedDocument>(read);
  const Snapshot& snapshot = named.document.snapshot();
  const std::vector<Diagnostic> diagnostics = syntax_diagnostics(snapshot);
  report_errors_and_warnings(snapshot, diagnostics, named.file_names);
  std::string lines;
  for (const Block& block : snapshot.blocks()) {
    for (const DefinitionSyntax& definition : block.parsed->definitions) {
      if (definition.readable) lines += print_source(*block.parsed, definition) + "\n";
    }
  }
  if (const auto failure = write_output(options.output, lines)) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  return has_error(diagnostics) ? ExitCode::DocumentHasErrors : ExitCode::Fine;
}

}  // namespace

Subcommand add_print(CLI::App& program) {
  const auto options = std::make_shared<PrintOptions>();
  CLI::App* const arguments = program.add_subcommand("print", "Write each definition fully parenthesised, one a line");
  arguments->add_option("FILE", options->file, "a LaTeX document, - for standard input")->required();
  arguments->add_option("-o,--output", options->output, "the file to write, - for standard output")->type_name("OUT");
  return {arguments, [options] { return print(*options); }};
}

}  // namespace texbrdf::cli

#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/exit_code.h"

namespace texbrdf::cli {

/// A subcommand as the command line knows it: where its arguments are parsed, and what runs once they are.
struct Subcommand {
  CLI::App* arguments;
  std::function<ExitCode()> run;
};

// Each adds its own arguments to the program; each has its own file.
Subcommand add_check(CLI::App& program);
Subcommand add_compile(CLI::App& program);
Subcommand add_eval(CLI::App& program);
Subcommand add_render(CLI::App& program);
Subcommand add_plot(CLI::App& program);
Subcommand add_view(CLI::App& program);
Subcommand add_print(CLI::App& program);
Subcommand add_ast(CLI::App& program);
Subcommand add_lsp(CLI::App& program);
// Not shown by --help: the program itself and the documentation use them.
Subcommand add_render_worker(CLI::App& program);
Subcommand add_diagnostics_page(CLI::App& program);

}  // namespace texbrdf::cli

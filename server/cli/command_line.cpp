#include "cli/command_line.h"

#include <fmt/core.h>

#include <array>
#include <csignal>
#include <exception>
#include <vector>

#include "cli/messages.h"
#include "cli/subcommands.h"
#include "source/internal_error.h"

namespace texbrdf::cli {
namespace {

constexpr std::array kSubcommands = {add_check, add_compile, add_eval, add_render,        add_print,           add_plot,
                                     add_view,  add_ast,     add_lsp,  add_render_worker, add_diagnostics_page};

ExitCode run_parsed(CLI::App& program, const std::vector<Subcommand>& subcommands, int argc, const char* const* argv) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are "errors" of this library too, with an exit code of 0.
    return program.exit(error) == 0 ? ExitCode::Fine : ExitCode::BadUsage;
  }
  for (const Subcommand& subcommand : subcommands) {
    if (subcommand.arguments->parsed()) return subcommand.run();
  }
  return ExitCode::BadUsage;
}

ExitCode run_guarded(int argc, const char* const* argv) {
  try {
    CLI::App program("A compiler for BRDFs written as LaTeX equations.", "texbrdf");
    program.set_version_flag("--version", "texbrdf " TEXBRDF_VERSION);
    program.require_subcommand(1);
    program.footer(
        "Exit status: 0 fine, 1 the document has errors, 2 bad usage or a file that cannot be read or written,\n"
        "3 no renderer.");
    std::vector<Subcommand> subcommands;
    for (const auto add : kSubcommands) subcommands.push_back(add(program));
    return run_parsed(program, subcommands, argc, argv);
  } catch (const InternalError& fault) {
    print_message(fmt::format("internal error: {} (this is a fault of texbrdf, please report it)", fault.what()));
  } catch (const std::bad_alloc&) {
    print_message("out of memory");
  }
  return ExitCode::InternalFault;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  // A reader that goes away is an error of the write, not the end of the process: the daemon and the render worker's
  // client live on. Ordinary output restores the default (see files.cpp).
  std::signal(SIGPIPE, SIG_IGN);
  return static_cast<int>(run_guarded(argc, argv));
}

}  // namespace texbrdf::cli

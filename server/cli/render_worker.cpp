#include <unistd.h>

#include "cli/subcommands.h"
#include "render/worker.h"

namespace texbrdf::cli {

Subcommand add_render_worker(CLI::App& program) {
  CLI::App* const arguments = program.add_subcommand("render-worker", "Draw for the process that started this one");
  arguments->group("");  // hidden
  return {arguments, [] { return static_cast<ExitCode>(render::run_render_worker(STDIN_FILENO, STDOUT_FILENO)); }};
}

}  // namespace texbrdf::cli

#include <memory>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/subcommands.h"
#include "diagnostics/render_catalogue.h"

namespace texbrdf::cli {

Subcommand add_diagnostics_page(CLI::App& program) {
  const auto output = std::make_shared<std::string>("-");
  CLI::App* const arguments = program.add_subcommand("diagnostics-page", "Write docs/diagnostics.md");
  arguments->group("");  // hidden
  arguments->add_option("-o,--output", *output, "the file to write, - for standard output");
  return {arguments, [output] {
            const auto failure = write_output(*output, render_catalogue());
            if (failure) print_message(failure->message);
            return failure ? ExitCode::BadUsage : ExitCode::Fine;
          }};
}

}  // namespace texbrdf::cli

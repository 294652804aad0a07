#include "lsp/server.h"

#include <memory>

#include "cli/subcommands.h"

namespace texbrdf::cli {

Subcommand add_lsp(CLI::App& program) {
  const auto options = std::make_shared<lsp::ServerOptions>();
  options->version = TEXBRDF_VERSION;
  CLI::App* const arguments = program.add_subcommand("lsp", "Serve editors over the language server protocol");
  arguments->add_flag("--stdio")->description("talk over standard input and output (there is no other way)");
  const std::map<std::string, lsp::LogLevel> levels{{"error", lsp::LogLevel::Error},
                                                    {"warning", lsp::LogLevel::Warning},
                                                    {"info", lsp::LogLevel::Info},
                                                    {"debug", lsp::LogLevel::Debug},
                                                    {"trace", lsp::LogLevel::Trace}};
  arguments->add_option("--log-level", options->log_level, "error, warning, info, debug or trace")
      ->transform(CLI::CheckedTransformer(levels).description(""))
      ->type_name("LEVEL");
  arguments->add_option("--log-file", options->log_file, "where the log goes instead of standard error")
      ->type_name("FILE");
  arguments
      ->add_option("--preview-port", options->preview_port,
                   "serve the preview to browsers of this machine at this port (0: any that is free)")
      ->type_name("PORT");
  return {arguments, [options] { return static_cast<ExitCode>(lsp::run_server(*options)); }};
}

}  // namespace texbrdf::cli

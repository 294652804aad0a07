#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lsp/log.h"

namespace texbrdf::lsp {

class Channel;

/// Where the explanations of diagnostics are published; a code's anchor follows.
inline constexpr const char* kDefaultDocsUrl = "https://texbrdf.github.io/texbrdf/diagnostics.html";

struct ServerOptions {
  int input_fd = 0;
  int output_fd = 1;
  LogLevel log_level = LogLevel::Info;
  std::string log_file = {};  ///< empty: standard error
  std::string version = {};   ///< of the program, for `serverInfo` and the log
  std::string docs_url = kDefaultDocsUrl;
  /// False: previews have values but no pictures, and diagnostics wait for all that is computed for them.
  bool starts_threads = true;
  std::optional<uint16_t> preview_port = {};  ///< previews for browsers; 0: any port that is free; nothing: none
  /// False once the process of that id is gone; empty: the system is asked.
  std::function<bool(int64_t)> process_alive = {};
};

/// Serves the language server protocol until the client ends it. Returns the status to exit with: 0 after `shutdown`
/// and `exit`, 1 when the client went away or sent `exit` alone, 2 when the log file cannot be written.
int run_server(const ServerOptions& options);
/// The same over any channel; the file descriptors and the log file of the options are not used.
int run_server(Channel& channel, Log& log, const ServerOptions& options);

}  // namespace texbrdf::lsp

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// Where a log's lines go: a file, or standard error. A reader that does not keep up loses lines; it cannot stop the
/// writer.
class LogOutput {
 public:
  /// Standard error.
  LogOutput();
  /// Appends to the file; nothing where it cannot be written.
  static std::optional<LogOutput> to_file(const std::string& path);
  ~LogOutput();
  LogOutput(LogOutput&& other) noexcept;
  LogOutput& operator=(LogOutput&&) = delete;

  void write(std::string_view line);

 private:
  explicit LogOutput(int fd) : fd_(fd), owned_(true) {}

  int fd_;
  bool owned_ = false;
};

}  // namespace texbrdf::lsp

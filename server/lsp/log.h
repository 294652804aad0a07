#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// A level shows itself and all before it.
enum class LogLevel : uint8_t { Error, Warning, Info, Debug, Trace };

std::string_view log_level_name(LogLevel level);  // "error", "warning", "info", "debug", "trace"
std::optional<LogLevel> log_level(std::string_view name);

/// What a bug report needs, one line an event: seconds since the start, level, message. Control characters in a message
/// are shown as `\xNN`, so that an event is always one line.
class Log {
 public:
  using Sink = std::function<void(std::string_view line)>;

  Log(LogLevel level, Sink sink);

  LogLevel level() const { return level_; }
  void set_level(LogLevel level) { level_ = level; }
  bool shows(LogLevel level) const { return level <= level_; }
  void write(LogLevel level, std::string_view message);

  void error(std::string_view message) { write(LogLevel::Error, message); }
  void warning(std::string_view message) { write(LogLevel::Warning, message); }
  void info(std::string_view message) { write(LogLevel::Info, message); }
  void debug(std::string_view message) { write(LogLevel::Debug, message); }
  void trace(std::string_view message) { write(LogLevel::Trace, message); }

 private:
  LogLevel level_;
  Sink sink_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace texbrdf::lsp

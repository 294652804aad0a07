#include "lsp/log.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace texbrdf::lsp {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"error", "warning", "info", "debug", "trace"};

std::string on_one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      fmt::format_to(std::back_inserter(line), "\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace

std::string_view log_level_name(LogLevel level) {
  return kNames[static_cast<std::size_t>(level)];
}

std::optional<LogLevel> log_level(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<LogLevel>(i);
  }
  return std::nullopt;
}

Log::Log(LogLevel level, Sink sink) : level_(level), sink_(std::move(sink)), start_(std::chrono::steady_clock::now()) {}

void Log::write(LogLevel level, std::string_view message) {
  if (!shows(level)) return;
  const std::chrono::duration<double> age = std::chrono::steady_clock::now() - start_;
  sink_(fmt::format("[{:10.4f}] {:7} {}\n", age.count(), log_level_name(level), on_one_line(message)));
}

}  // namespace texbrdf::lsp

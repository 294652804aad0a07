#include "lsp/log_output.h"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <unistd.h>

namespace texbrdf::lsp {
namespace {

constexpr int kNewFileMode = 0600;  // a log tells where the preview for browsers is

}  // namespace

LogOutput::LogOutput() : fd_(STDERR_FILENO) {}

std::optional<LogOutput> LogOutput::to_file(const std::string& path) {
  const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kNewFileMode);
  if (fd < 0) return std::nullopt;
  return LogOutput(fd);
}

LogOutput::~LogOutput() {
  if (owned_) close(fd_);
}

LogOutput::LogOutput(LogOutput&& other) noexcept : fd_(other.fd_), owned_(other.owned_) {
  other.owned_ = false;
}

/// A pipe that is ready takes PIPE_BUF bytes without blocking.
void LogOutput::write(std::string_view line) {
  pollfd ready = {fd_, POLLOUT, 0};
  if (poll(&ready, 1, 0) <= 0 || (ready.revents & POLLOUT) == 0) return;
  const std::string_view whole = line.substr(0, PIPE_BUF);
  if (::write(fd_, whole.data(), whole.size()) < 0) return;  // there is nowhere to tell it
}

}  // namespace texbrdf::lsp

#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/channel.h"

namespace texbrdf::lsp {

/// A channel over two file descriptors (pipes, sockets, files). While the client does not read, what is written is kept
/// and reading goes on, so that two full pipes cannot block each other; only beyond a limit is nothing more read.
class FdChannel final : public Channel {
 public:
  /// Does not own the descriptors, but writes without blocking until it is destroyed. Ignores SIGPIPE in this process.
  FdChannel(int input_fd, int output_fd);
  ~FdChannel() override;
  FdChannel(const FdChannel&) = delete;
  FdChannel& operator=(const FdChannel&) = delete;

  Status read(std::string& buffer, int timeout_ms) override;
  void write(std::string bytes) override;
  void flush() override;
  void wake() override;

 private:
  Status receive(std::string& buffer);
  void send();
  std::size_t written(std::string_view bytes);

  int input_fd_;
  int output_fd_;
  int output_flags_;
  int wake_fd_;  ///< an eventfd
  std::vector<char> chunk_;
  std::deque<std::string> outgoing_;
  std::size_t sent_ = 0;    ///< bytes of the first outgoing text that the client has
  std::size_t unsent_ = 0;  ///< bytes that it has not
  bool input_closed_ = false;
  bool output_closed_ = false;
};

}  // namespace texbrdf::lsp

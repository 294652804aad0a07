#include "lsp/fd_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

namespace texbrdf::lsp {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 16;
/// With so much unsent, a client that only writes is not read any more.
constexpr std::size_t kMaxUnsentBytes = std::size_t{64} << 20;
constexpr int kFlushTimeoutMs = 2000;
/// Asked of a pipe, so that a large answer does not wait for the client to take every 64 KiB of it.
constexpr int kPipeBytes = 1 << 20;

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

FdChannel::FdChannel(int input_fd, int output_fd)
    : input_fd_(input_fd),
      output_fd_(output_fd),
      output_flags_(fcntl(output_fd, F_GETFL)),
      wake_fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      chunk_(kReadBytes) {
  std::signal(SIGPIPE, SIG_IGN);
  if (output_flags_ >= 0) fcntl(output_fd_, F_SETFL, output_flags_ | O_NONBLOCK);
  fcntl(output_fd_, F_SETPIPE_SZ, kPipeBytes);
}

FdChannel::~FdChannel() {
  if (output_flags_ >= 0) fcntl(output_fd_, F_SETFL, output_flags_);
  if (wake_fd_ >= 0) close(wake_fd_);
}

void FdChannel::wake() {
  const uint64_t one = 1;
  if (::write(wake_fd_, &one, sizeof one) < 0) return;  // it is awake already
}

Channel::Status FdChannel::read(std::string& buffer, int timeout_ms) {
  if (input_closed_ || output_closed_) return Status::Closed;
  std::array<pollfd, 3> watched = {{{input_fd_, POLLIN, 0}, {output_fd_, POLLOUT, 0}, {wake_fd_, POLLIN, 0}}};
  if (unsent_ > kMaxUnsentBytes) watched[0].fd = -1;
  if (unsent_ == 0) watched[1].fd = -1;
  if (poll(watched.data(), watched.size(), timeout_ms) <= 0) return Status::Idle;
  if (watched[1].revents != 0) send();
  uint64_t wakes = 0;
  if (watched[2].revents != 0 && ::read(wake_fd_, &wakes, sizeof wakes) < 0) return Status::Idle;
  if (output_closed_) return Status::Closed;
  return watched[0].revents != 0 ? receive(buffer) : Status::Idle;
}

Channel::Status FdChannel::receive(std::string& buffer) {
  const ssize_t count = ::read(input_fd_, chunk_.data(), chunk_.size());
  if (count < 0 && would_block()) return Status::Idle;
  if (count <= 0) {
    input_closed_ = true;
    return Status::Closed;
  }
  buffer.append(chunk_.data(), static_cast<std::size_t>(count));
  return Status::Data;
}

void FdChannel::write(std::string bytes) {
  if (bytes.empty() || output_closed_) return;
  unsent_ += bytes.size();
  outgoing_.push_back(std::move(bytes));
  if (outgoing_.size() == 1) send();
}

void FdChannel::send() {
  while (!outgoing_.empty()) {
    const std::string& first = outgoing_.front();
    const std::size_t taken = written(std::string_view(first).substr(sent_));
    sent_ += taken;
    unsent_ -= taken;
    if (sent_ < first.size()) break;
    outgoing_.pop_front();
    sent_ = 0;
  }
  if (!output_closed_) return;
  outgoing_.clear();
  sent_ = unsent_ = 0;
}

/// How many of the bytes the client takes now.
std::size_t FdChannel::written(std::string_view bytes) {
  std::size_t count = 0;
  while (count < bytes.size()) {
    const ssize_t taken = ::write(output_fd_, bytes.data() + count, bytes.size() - count);
    if (taken >= 0) {
      count += static_cast<std::size_t>(taken);
    } else if (errno != EINTR) {
      output_closed_ = !would_block();
      break;
    }
  }
  return count;
}

void FdChannel::flush() {
  while (unsent_ > 0) {
    pollfd watched = {output_fd_, POLLOUT, 0};
    if (poll(&watched, 1, kFlushTimeoutMs) <= 0) return;
    send();
  }
}

}  // namespace texbrdf::lsp

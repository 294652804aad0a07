#include "render/channel.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

namespace texbrdf::render {

namespace {

constexpr uint32_t kMark = 0x52425854;  // "TXBR"
/// Memory is taken as bytes arrive: a length alone costs nothing.
constexpr std::size_t kReadStep = std::size_t{1} << 20;

struct Header {
  uint32_t mark;
  uint32_t kind;
  uint32_t length;
};

ChannelFault closed() {
  return {ChannelFaultKind::Closed, "the connection is closed"};
}

ChannelFault system_fault(const char* what) {
  return {ChannelFaultKind::Closed, fmt::format("{}: {}", what, std::strerror(errno))};
}

int milliseconds_until(Clock::time_point deadline) {
  if (deadline == kNoDeadline) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<int64_t>(left, 0, 1'000'000'000));
}

std::optional<ChannelFault> wait_for(int fd, int16_t events, Clock::time_point deadline) {
  while (true) {
    pollfd entry{fd, events, 0};
    const int ready = poll(&entry, 1, milliseconds_until(deadline));
    if (ready > 0) return std::nullopt;
    if (ready == 0) return ChannelFault{ChannelFaultKind::Deadline, "no answer in time"};
    if (errno != EINTR) return system_fault("poll");
  }
}

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

std::optional<ChannelFault> read_exactly(int fd, std::span<uint8_t> bytes, Clock::time_point deadline) {
  while (!bytes.empty()) {
    if (auto fault = wait_for(fd, POLLIN, deadline)) return fault;
    const ssize_t count = read(fd, bytes.data(), bytes.size());
    if (count == 0) return closed();
    if (count < 0 && !would_block()) return system_fault("read");
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

ssize_t write_some(int fd, std::span<const uint8_t> bytes) {
  const ssize_t count = send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return count < 0 && errno == ENOTSOCK ? write(fd, bytes.data(), bytes.size()) : count;
}

std::optional<ChannelFault> write_exactly(int fd, std::span<const uint8_t> bytes, Clock::time_point deadline) {
  while (!bytes.empty()) {
    if (auto fault = wait_for(fd, POLLOUT, deadline)) return fault;
    const ssize_t count = write_some(fd, bytes);
    if (count < 0 && !would_block()) return errno == EPIPE ? closed() : system_fault("write");
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

}  // namespace

std::variant<Message, ChannelFault> receive_message(int fd, Clock::time_point deadline) {
  std::array<uint8_t, sizeof(Header)> bytes;
  if (auto fault = read_exactly(fd, bytes, deadline)) return *fault;
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.mark != kMark) return ChannelFault{ChannelFaultKind::Garbage, "bytes that are no message"};
  if (header.length > kMaxPayloadBytes) {
    return ChannelFault{ChannelFaultKind::Garbage, fmt::format("a message of {} bytes", header.length)};
  }
  Message message{header.kind, {}};
  while (message.payload.size() < header.length) {
    const std::size_t done = message.payload.size();
    message.payload.resize(std::min<std::size_t>(header.length, done + kReadStep));
    if (auto fault = read_exactly(fd, std::span(message.payload).subspan(done), deadline)) return *fault;
  }
  return message;
}

std::variant<std::monostate, ChannelFault> send_message(int fd, uint32_t kind, std::span<const uint8_t> payload,
                                                        Clock::time_point deadline) {
  if (payload.size() > kMaxPayloadBytes) return ChannelFault{ChannelFaultKind::Garbage, "too long a message"};
  const Header header{kMark, kind, static_cast<uint32_t>(payload.size())};
  std::array<uint8_t, sizeof header> bytes;
  std::memcpy(bytes.data(), &header, sizeof header);
  if (auto fault = write_exactly(fd, bytes, deadline)) return *fault;
  if (auto fault = write_exactly(fd, payload, deadline)) return *fault;
  return std::monostate{};
}

}  // namespace texbrdf::render

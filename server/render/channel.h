#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace texbrdf::render {

/// The protocol's envelope over a pipe or a socket: a mark, a kind and a length, then that many bytes.
struct Message {
  uint32_t kind = 0;
  std::vector<uint8_t> payload;
};

inline constexpr uint32_t kMaxPayloadBytes = 80U << 20;

enum class ChannelFaultKind : uint8_t {
  Closed,    ///< the other side is gone
  Deadline,  ///< it said nothing, or took nothing, in time
  Garbage,   ///< what it says is no message
};

struct ChannelFault {
  ChannelFaultKind kind;
  std::string message;
};

using Clock = std::chrono::steady_clock;
inline constexpr Clock::time_point kNoDeadline = Clock::time_point::max();

/// Waits for a whole message, however it is cut into pieces.
std::variant<Message, ChannelFault> receive_message(int fd, Clock::time_point deadline);
/// A deadline holds only if `fd` does not block. Raises no SIGPIPE on a socket.
std::variant<std::monostate, ChannelFault> send_message(int fd, uint32_t kind, std::span<const uint8_t> payload,
                                                        Clock::time_point deadline);

}  // namespace texbrdf::render

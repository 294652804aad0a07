#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace texbrdf::lsp {

/// A message longer than this is refused without being stored.
inline constexpr uint64_t kMaxMessageBytes = uint64_t{256} << 20;
/// A header block longer than this is no header block.
inline constexpr std::size_t kMaxHeaderBytes = 16384;

/// The content of one message; valid until the decoder is used again.
struct Frame {
  std::string_view body;
};

/// What could not be read as a message, told in one line.
struct FramingProblem {
  std::string message;
};

/// Cuts a stream of bytes into the messages of the base protocol: `Content-Length: N`, other header fields, an empty
/// line, N bytes. After anything else it reports one problem and goes on at the next `Content-Length:` in the stream.
class FrameDecoder {
 public:
  explicit FrameDecoder(uint64_t max_message_bytes = kMaxMessageBytes) : max_message_bytes_(max_message_bytes) {}

  /// Where arriving bytes are appended.
  std::string& input() { return buffer_; }
  /// The next message or problem; nothing while the rest of a message is still to come.
  std::optional<std::variant<Frame, FramingProblem>> next();
  /// True when the stream stops in the middle of a message.
  bool inside_message() const { return start_ < buffer_.size() || content_length_.has_value(); }

 private:
  enum class HeaderState { Complete, Incomplete, Broken };
  HeaderState read_header(std::string& problem);
  bool skip_to_header();
  void consume(std::size_t bytes);

  uint64_t max_message_bytes_;
  std::string buffer_;
  std::size_t start_ = 0;  ///< bytes of the buffer that were consumed
  std::optional<uint64_t> content_length_;
  bool lost_ = false;  ///< skipping to the next header
};

/// A message ready to be sent.
std::string frame(std::string body);

}  // namespace texbrdf::lsp

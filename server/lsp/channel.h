#pragma once

#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// The bytes to and from the client. One thread uses it.
class Channel {
 public:
  enum class Status { Data, Idle, Closed };
  static constexpr int kForever = -1;

  virtual ~Channel() = default;
  /// Appends what has arrived. Waits at most `timeout_ms` for something: 0 takes only what is there already.
  /// Idle: nothing came in that time. Closed: nothing will ever come.
  virtual Status read(std::string& buffer, int timeout_ms) = 0;
  /// Takes the bytes at once and passes them on as the client reads; never waits.
  virtual void write(std::string bytes) = 0;
  /// Ends a wait in `read`, now or the next one. The only call for any thread.
  virtual void wake() = 0;
  /// Waits until the client has taken all that was written, but not for ever.
  virtual void flush() = 0;
};

}  // namespace texbrdf::lsp

// Any bytes on the language server's input. An input that starts with `#` is a session as a person writes it: one
// message a line, which this frames; any other is given to the server as it is.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "lsp/channel.h"
#include "lsp/log.h"
#include "lsp/server.h"

namespace {

using namespace texbrdf::lsp;

constexpr std::size_t kMaxInput = 1 << 16;
constexpr std::size_t kPiece = 97;  // small enough that headers and messages are torn apart

std::string framed(std::string_view session) {
  std::string bytes;
  while (!session.empty()) {
    const std::string_view line = session.substr(0, session.find('\n'));
    session.remove_prefix(std::min(session.size(), line.size() + 1));
    bytes += "Content-Length: " + std::to_string(line.size()) + "\r\n\r\n";
    bytes += line;
  }
  return bytes;
}

class MemoryChannel final : public Channel {
 public:
  explicit MemoryChannel(std::string input) : input_(std::move(input)) {}

  Status read(std::string& buffer, int) override {
    if (position_ == input_.size()) return Status::Closed;
    const std::string_view piece = std::string_view(input_).substr(position_, kPiece);
    buffer += piece;
    position_ += piece.size();
    return Status::Data;
  }
  void write(std::string) override {}
  void wake() override {}
  void flush() override {}

 private:
  std::string input_;
  std::size_t position_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size == 0 || size > kMaxInput) return 0;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  MemoryChannel channel(input.front() == '#' ? framed(input.substr(input.find('\n') + 1)) : std::string(input));
  Log log(LogLevel::Trace, [](std::string_view) {});
  ServerOptions options;
  options.starts_threads = false;
  options.process_alive = [](int64_t) { return true; };
  run_server(channel, log, options);
  return 0;
}

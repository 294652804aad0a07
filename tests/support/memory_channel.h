#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lsp/channel.h"

namespace texbrdf::test {

/// A client without threads or clock: each time the server waits for input it gets the next chunk, at once. An empty
/// chunk is a wait in which nothing came; behind the last chunk the input is closed.
class MemoryChannel final : public lsp::Channel {
 public:
  void add(std::string chunk) { input_.push_back({std::move(chunk), {}}); }
  /// `before` is called when the chunk is taken.
  void add(std::string chunk, std::function<void()> before) { input_.push_back({std::move(chunk), std::move(before)}); }

  Status read(std::string& buffer, int timeout_ms) override {
    if (timeout_ms == 0) return Status::Idle;
    replies_.emplace_back();
    if (input_.empty()) return Status::Closed;
    const auto [chunk, before] = std::move(input_.front());
    input_.pop_front();
    if (before) before();
    buffer += chunk;
    return chunk.empty() ? Status::Idle : Status::Data;
  }
  void write(std::string bytes) override { replies_.back() += bytes; }
  void flush() override {}
  void wake() override {}

  /// What was written after each chunk; the last one is behind the end of the input.
  const std::vector<std::string>& replies() const { return replies_; }

 private:
  std::deque<std::pair<std::string, std::function<void()>>> input_;
  std::vector<std::string> replies_;
};

}  // namespace texbrdf::test

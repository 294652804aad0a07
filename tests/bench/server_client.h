#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "lsp/channel.h"
#include "lsp/framing.h"
#include "lsp/log.h"
#include "lsp/server.h"

namespace texbrdf::test {

/// The two ends of a channel between threads of one process.
class ThreadChannel final : public lsp::Channel {
 public:
  Status read(std::string& buffer, int timeout_ms) override {
    std::unique_lock lock(mutex_);
    const auto is_ready = [this] { return !input_.empty() || is_closed_ || is_awake_; };
    from_client_.wait_for(lock, std::chrono::milliseconds(timeout_ms), is_ready);
    is_awake_ = false;
    if (!input_.empty()) {
      buffer += std::exchange(input_, {});
      return Status::Data;
    }
    return is_closed_ ? Status::Closed : Status::Idle;
  }
  void write(std::string bytes) override {
    const std::lock_guard lock(mutex_);
    output_.push_back(std::move(bytes));
    from_server_.notify_one();
  }
  void flush() override {}
  void wake() override {
    const std::lock_guard lock(mutex_);
    is_awake_ = true;
    from_client_.notify_one();
  }

  void send(std::string bytes) {
    const std::lock_guard lock(mutex_);
    input_ += bytes;
    from_client_.notify_one();
  }
  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    from_client_.notify_one();
  }
  /// Nothing where none comes in time.
  std::optional<std::string> receive(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    if (!from_server_.wait_for(lock, patience, [this] { return !output_.empty(); })) return std::nullopt;
    std::string message = std::move(output_.front());
    output_.pop_front();
    return message;
  }

 private:
  std::mutex mutex_;
  std::condition_variable from_client_;
  std::condition_variable from_server_;
  std::string input_;
  std::deque<std::string> output_;
  bool is_closed_ = false;
  bool is_awake_ = false;
};

/// A server on a thread of its own, and its client.
class ServerClient {
 public:
  /// `capabilities`: JSON.
  explicit ServerClient(std::string_view capabilities) : server_([this] { lsp::run_server(channel_, log_, {}); }) {
    request("initialize", std::string(R"({"processId":null,"capabilities":)").append(capabilities) + "}");
    notify("initialized", "{}");
  }
  ~ServerClient() {
    channel_.close();
    server_.join();
  }
  ServerClient(const ServerClient&) = delete;
  ServerClient& operator=(const ServerClient&) = delete;

  void notify(std::string_view method, std::string_view params) { send(method, params, {}); }
  /// The whole message of the answer.
  std::string request(std::string_view method, std::string_view params) {
    const std::string id = "\"id\":" + std::to_string(++last_id_);
    send(method, params, id + ",");
    return wait_for(id + ",");
  }
  /// The next message that holds the text; those before it are dropped.
  std::string wait_for(std::string_view text) {
    while (std::optional<std::string> message = receive(kPatience)) {
      if (message->find(text) != std::string::npos) return *std::move(message);
    }
    throw std::runtime_error("the server does not answer");
  }
  std::optional<std::string> receive(std::chrono::milliseconds patience) { return channel_.receive(patience); }

 private:
  static constexpr std::chrono::seconds kPatience{30};

  void send(std::string_view method, std::string_view params, std::string_view id) {
    std::string body = R"({"jsonrpc":"2.0",)";
    body.append(id).append(R"("method":")").append(method).append(R"(","params":)").append(params).append("}");
    channel_.send(lsp::frame(std::move(body)));
  }

  ThreadChannel channel_;
  lsp::Log log_{lsp::LogLevel::Error, [](std::string_view) {}};
  std::thread server_;
  int last_id_ = 0;
};

}  // namespace texbrdf::test

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "lsp/json_rpc.h"
#include "lsp/json_writer.h"
#include "lsp/log.h"

namespace texbrdf::lsp {

/// What the server says unasked: notifications, and requests of its own, whose replies are matched by their ids.
class Outbox {
 public:
  using Send = std::function<void(std::string body)>;
  using WriteParams = std::function<void(JsonWriter& params)>;
  using OnResult = std::function<void(const nlohmann::json& result)>;

  explicit Outbox(Log& log) : log_(log) {}

  /// Until then nothing is sent.
  void connect(Send send) { send_ = std::move(send); }

  void notify(std::string_view method, const WriteParams& write_params);
  /// `on_result` is called with what the client answers, with null where that is an error; not where it never answers.
  void request(std::string_view method, const WriteParams& write_params, OnResult on_result = {});
  void request(std::string_view method, OnResult on_result = {}) { request(method, nullptr, std::move(on_result)); }

  /// Replies that nobody waits for are a line of the log.
  void take_reply(const IncomingMessage& reply);
  /// Nothing that comes from now on has an effect.
  void forget_requests() { waiting_.clear(); }

 private:
  struct Waiting {
    std::string method;
    OnResult on_result;
  };

  Log& log_;
  Send send_ = [](const std::string&) {};
  int64_t next_id_ = 1;
  std::map<int64_t, Waiting> waiting_;
};

}  // namespace texbrdf::lsp

#include "lsp/outbox.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

namespace texbrdf::lsp {
namespace {

/// A client that never replies must not fill the memory: the oldest requests are given up.
constexpr std::size_t kMaxWaiting = 1000;

/// The id of a request of ours; no other JSON is one.
int64_t number_of(std::string_view id) {
  int64_t number = 0;
  const char* const begin = id.data();
  const char* const end = begin + id.size();
  return std::from_chars(begin, end, number).ptr == end ? number : 0;
}

}  // namespace

void Outbox::notify(std::string_view method, const WriteParams& write_params) {
  JsonWriter message;
  begin_notification(message, method);
  write_params(message);
  message.end_object();
  send_(message.take());
}

void Outbox::request(std::string_view method, const WriteParams& write_params, OnResult on_result) {
  const int64_t id = next_id_++;
  waiting_.emplace(id, Waiting{std::string(method), std::move(on_result)});
  if (waiting_.size() > kMaxWaiting) waiting_.erase(waiting_.begin());
  JsonWriter message;
  message.begin_object();
  message.member("jsonrpc", "2.0");
  message.member("id", id);
  message.member("method", method);
  if (write_params) {
    message.key("params");
    write_params(message);
  }
  message.end_object();
  send_(message.take());
}

void Outbox::take_reply(const IncomingMessage& reply) {
  const auto found = waiting_.find(number_of(reply.id));
  if (found == waiting_.end()) {
    log_.debug(fmt::format("a response that nobody waits for: {}", reply.id));
    return;
  }
  const Waiting waiting = std::move(found->second);
  waiting_.erase(found);
  if (reply.result == nullptr) {
    log_.warning(fmt::format("the client refused {}: {}", waiting.method, reply.problem.message));
  }
  if (waiting.on_result) waiting.on_result(reply.result == nullptr ? nlohmann::json() : *reply.result);
}

}  // namespace texbrdf::lsp

#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lsp/dispatcher.h"
#include "lsp/json_rpc.h"
#include "lsp/log.h"
#include "lsp/message_queue.h"
#include "lsp/session.h"

namespace texbrdf::lsp {

/// Answers one message after the other by the rules of JSON-RPC and of the protocol's phases. A fault of ours becomes
/// an error reply and a line of the log, and what is known of the documents is formed anew from their texts.
class MessageHandler {
 public:
  using Send = std::function<void(std::string body)>;

  /// All have to outlive the handler.
  MessageHandler(Session& session, const Dispatcher& methods, Log& log, Send send)
      : session_(session), methods_(methods), log_(log), send_(std::move(send)) {
    session_.outbox().connect([this](std::string body) { this->send(std::move(body)); });
  }
  MessageHandler(const MessageHandler&) = delete;
  MessageHandler& operator=(const MessageHandler&) = delete;

  void handle(const MessageQueue::Entry& entry);
  bool has_publications();
  /// Sends the diagnostics of one document that the client lacks.
  void publish_next();
  /// What was computed since the last time becomes part of what is published.
  void take_findings();
  /// While there is nothing else to do: previews follow their documents, and the next edits are prepared.
  void use_idle_time();

 private:
  bool is_in_reach(const IncomingMessage& message) const;
  void handle_request(const IncomingMessage& message, bool cancelled);
  void handle_notification(const IncomingMessage& message);
  void handle_response(const IncomingMessage& message);
  std::optional<ResponseError> refusal(const IncomingMessage& message, bool cancelled) const;
  std::optional<ResponseError> answer(const IncomingMessage& message, JsonWriter& result);
  void recover(std::string_view where, const std::exception& fault);
  bool is_resting() const;
  void send(std::string body);
  /// To whom the message is from that is being handled.
  void reply(std::string body);
  void reply_error(const IncomingMessage& message, const ResponseError& error);

  Session& session_;
  const Dispatcher& methods_;
  Log& log_;
  Send send_;
  int faults_ = 0;  ///< since the last message came
};

}  // namespace texbrdf::lsp

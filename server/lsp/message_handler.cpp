#include "lsp/message_handler.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <string_view>
#include <utility>

#include "lsp/progress.h"

namespace texbrdf::lsp {
namespace {

constexpr std::size_t kTracedBytes = 2000;
/// After so many faults nothing is tried until the next message.
constexpr int kMaxFaults = 8;

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "references" of "textDocument/references".
std::string_view last_part(std::string_view method) {
  return method.substr(method.rfind('/') + 1);
}

}  // namespace

void MessageHandler::handle(const MessageQueue::Entry& entry) {
  const IncomingMessage& message = entry.message;
  if (!session_.listens_to(entry.sender)) return;
  session_.serve(entry.sender);
  faults_ = 0;
  switch (message.kind) {
    case IncomingMessage::Kind::Request:
      ++session_.traffic().requests;
      handle_request(message, entry.cancelled);
      return;
    case IncomingMessage::Kind::Notification:
      ++session_.traffic().notifications;
      handle_notification(message);
      return;
    case IncomingMessage::Kind::Response:
      if (entry.sender == kEditor) handle_response(message);
      return;
    case IncomingMessage::Kind::Broken:
      log_.error(fmt::format("broken message: {}", message.problem.message));
      reply_error(message, message.problem);
      return;
  }
}

void MessageHandler::handle_request(const IncomingMessage& message, bool cancelled) {
  const Stopwatch watch;
  JsonWriter response;
  begin_response(response, message.id);
  auto error = refusal(message, cancelled);
  if (!error) error = answer(message, response);
  if (error) {
    if (cancelled) ++session_.traffic().cancelled;
    reply_error(message, *error);
  } else {
    response.end_object();
    reply(response.take());
  }
  log_.debug(fmt::format("{} {}: {:.3f} ms{}", message.method, message.id, watch.milliseconds(),
                         error ? fmt::format(", error {}: {}", static_cast<int>(error->code), error->message) : ""));
}

bool MessageHandler::is_in_reach(const IncomingMessage& message) const {
  return session_.speaker() == kEditor || is_for_browsers(message.method);
}

/// Why a request is not even looked at in the present state.
std::optional<ResponseError> MessageHandler::refusal(const IncomingMessage& message, bool cancelled) const {
  if (session_.phase() == Session::Phase::ShutDown) {
    return ResponseError{ErrorCode::InvalidRequest, "the server is shut down"};
  }
  if (session_.phase() == Session::Phase::Created && message.method != "initialize") {
    return ResponseError{ErrorCode::ServerNotInitialized, "the server is not initialized"};
  }
  if (!is_in_reach(message)) return ResponseError{ErrorCode::MethodNotFound, "no method " + message.method};
  if (cancelled) return ResponseError{ErrorCode::RequestCancelled, "cancelled by the client"};
  return std::nullopt;
}

/// A fault of ours in a handler is told and ends there.
std::optional<ResponseError> MessageHandler::answer(const IncomingMessage& message, JsonWriter& result) {
  const Dispatcher::Request* handler = methods_.find_request(message.method);
  if (session_.is_switched_off(message.method)) {
    result.null();
    return std::nullopt;
  }
  if (handler == nullptr) return ResponseError{ErrorCode::MethodNotFound, "no method " + message.method};
  if (session_.answer_about_scene(message.method, *message.params, result)) return std::nullopt;
  try {
    const bool is_editors = session_.speaker() == kEditor;
    const Progress progress(session_.outbox(), is_editors ? work_done_token(*message.params) : std::string(),
                            last_part(message.method));
    return (*handler)(*message.params, result);
  } catch (const std::exception& fault) {
    recover(message.method, fault);
    return ResponseError{ErrorCode::InternalError, fault.what()};
  }
}

void MessageHandler::handle_notification(const IncomingMessage& message) {
  const bool running = session_.phase() == Session::Phase::Running;
  const Dispatcher::Notification* handler = methods_.find_notification(message.method);
  if (handler == nullptr || !is_in_reach(message) || (!running && message.method != "exit")) {
    log_.debug(fmt::format("{} is ignored", message.method));
    return;
  }
  const Stopwatch watch;
  try {
    const std::string problem = (*handler)(*message.params);
    if (!problem.empty()) log_.error(fmt::format("{} is ignored: {}", message.method, problem));
  } catch (const std::exception& fault) {
    recover(message.method, fault);
  }
  log_.debug(fmt::format("{}: {:.3f} ms", message.method, watch.milliseconds()));
}

void MessageHandler::handle_response(const IncomingMessage& message) {
  try {
    session_.outbox().take_reply(message);
  } catch (const std::exception& fault) {
    recover("the reply " + message.id, fault);
  }
}

bool MessageHandler::has_publications() {
  if (is_resting()) return false;
  try {
    return session_.has_publications();
  } catch (const std::exception& fault) {
    recover("the projects", fault);
    return false;
  }
}

void MessageHandler::publish_next() {
  const Stopwatch watch;
  try {
    JsonWriter notification;
    begin_notification(notification, "textDocument/publishDiagnostics");
    session_.write_next_publication(notification);
    notification.end_object();
    ++session_.traffic().published;
    send(notification.take());
  } catch (const std::exception& fault) {
    recover("diagnostics", fault);
  }
  log_.debug(fmt::format("textDocument/publishDiagnostics: {:.3f} ms", watch.milliseconds()));
}

void MessageHandler::take_findings() {
  if (is_resting()) return;
  try {
    session_.take_findings();
  } catch (const std::exception& fault) {
    recover("findings", fault);
  }
}

void MessageHandler::use_idle_time() {
  if (is_resting()) return;
  try {
    session_.refresh_previews();
    session_.lead_browsers();
    session_.prepare_for_edits();
  } catch (const std::exception& fault) {
    recover("idle time", fault);
  }
}

/// What was published may have been wrong already. A fault that comes again is one of the texts as they are.
void MessageHandler::recover(std::string_view where, const std::exception& fault) {
  log_.error(fmt::format("internal error in {}: {}", where, fault.what()));
  session_.start_anew();
  if (++faults_ == 1) session_.publish_anew();
}

bool MessageHandler::is_resting() const {
  return faults_ >= kMaxFaults;
}

void MessageHandler::send(std::string body) {
  if (log_.shows(LogLevel::Trace)) log_.trace(fmt::format("-> {}", std::string_view(body).substr(0, kTracedBytes)));
  send_(std::move(body));
}

void MessageHandler::reply(std::string body) {
  if (session_.speaker() == kEditor) return send(std::move(body));
  session_.browsers().send(session_.speaker(), std::move(body));
}

void MessageHandler::reply_error(const IncomingMessage& message, const ResponseError& error) {
  ++session_.traffic().errors;
  reply(error_text(message.id, error));
}

}  // namespace texbrdf::lsp

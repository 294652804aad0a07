#include "lsp/message_queue.h"

#include <fmt/format.h>

#include <utility>

namespace texbrdf::lsp {
namespace {

/// With so much waiting to be handled, nothing more is read.
constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20;
constexpr std::size_t kTracedBytes = 2000;

}  // namespace

Channel::Status MessageQueue::receive(int timeout_ms) {
  Channel::Status status = Channel::Status::Idle;
  for (int wait = timeout_ms; waiting_bytes_ < kMaxWaitingBytes; wait = 0) {
    const Channel::Status now = channel_.read(decoder_.input(), wait);
    if (now == Channel::Status::Idle) break;
    status = now;
    if (now == Channel::Status::Closed) break;
    take_frames();
  }
  return status;
}

void MessageQueue::take_frames() {
  while (auto next = decoder_.next()) {
    if (const auto* problem = std::get_if<FramingProblem>(&*next)) {
      IncomingMessage message;
      message.id = "null";
      message.problem = {ErrorCode::ParseError, fmt::format("unreadable input is skipped: {}", problem->message)};
      add(std::move(message), 0);
      continue;
    }
    const std::string_view body = std::get<Frame>(*next).body;
    trace(body);
    add(parse_message(body), body.size());
  }
}

void MessageQueue::add_from(ViewerId browser, std::string_view body) {
  trace(body);
  waiting_bytes_ += body.size();
  entries_.push_back({.message = parse_message(body), .bytes = body.size(), .sender = browser});
}

void MessageQueue::trace(std::string_view body) const {
  if (log_.shows(LogLevel::Trace)) log_.trace(fmt::format("<- {}", body.substr(0, kTracedBytes)));
}

void MessageQueue::add(IncomingMessage message, std::size_t bytes) {
  const bool notification = message.kind == IncomingMessage::Kind::Notification;
  if (notification && message.method == "$/cancelRequest") {
    if (const auto id = cancelled_id(*message.params)) cancel(*id);
  }
  waiting_bytes_ += bytes;
  entries_.push_back({std::move(message), bytes});
}

void MessageQueue::cancel(std::string_view id) {
  for (Entry& entry : entries_) {
    const bool is_editors = entry.sender == kEditor && entry.message.kind == IncomingMessage::Kind::Request;
    if (is_editors && entry.message.id == id) entry.cancelled = true;
  }
}

MessageQueue::Entry MessageQueue::pop() {
  Entry entry = std::move(entries_.front());
  entries_.pop_front();
  waiting_bytes_ -= entry.bytes;
  return entry;
}

}  // namespace texbrdf::lsp

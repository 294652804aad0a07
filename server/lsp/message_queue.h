#pragma once

#include <deque>
#include <optional>
#include <string_view>

#include "lsp/browsers.h"
#include "lsp/channel.h"
#include "lsp/framing.h"
#include "lsp/json_rpc.h"
#include "lsp/log.h"

namespace texbrdf::lsp {

/// Messages that have arrived and are not handled yet, in their order. Reading ahead is what lets a cancellation
/// overtake the request that it is about.
class MessageQueue {
 public:
  MessageQueue(Channel& channel, Log& log) : channel_(channel), log_(log) {}

  struct Entry {
    IncomingMessage message;
    std::size_t bytes = 0;
    bool cancelled = false;
    ViewerId sender = kEditor;
  };

  /// Takes in what the client has sent, up to a limit; waits at most `timeout_ms` for the first of it.
  Channel::Status receive(int timeout_ms);
  /// One message of a browser.
  void add_from(ViewerId browser, std::string_view body);
  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  Entry pop();
  /// True when the stream stops in the middle of a message.
  bool inside_message() const { return decoder_.inside_message(); }

 private:
  void take_frames();
  void add(IncomingMessage message, std::size_t bytes);
  void trace(std::string_view body) const;
  void cancel(std::string_view id);

  Channel& channel_;
  Log& log_;
  FrameDecoder decoder_;
  std::deque<Entry> entries_;
  std::size_t waiting_bytes_ = 0;  ///< of all entries
};

}  // namespace texbrdf::lsp

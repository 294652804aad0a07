#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "source/result.h"
#include "web/mailbox.h"
#include "web/routes.h"

namespace texbrdf::web {

struct EventServerLimits {
  std::size_t connections = 64;
  std::size_t streams = 32;
  std::size_t header_bytes = std::size_t{8} << 10;
  std::size_t message_bytes = std::size_t{64} << 10;
  std::size_t unsent_bytes = std::size_t{64} << 20;  ///< of one stream, which then ends
  int request_seconds = 30;                          ///< for a whole request, and between two on the same connection
  Mailbox::Limits mailbox = {};
};

struct EventServerOptions {
  uint16_t port = 0;  ///< 0: any that is free
  std::vector<Page> pages;
  /// Called on the server's thread when `take` has something to give.
  std::function<void()> wake;
  EventServerLimits limits = {};
};

/// Serves a few pages to browsers of this machine: over HTTP on the loopback interface, behind a token that nobody can
/// guess. A page hears of events at `events` (server-sent events) and posts messages to `messages/CLIENT`. Knows
/// nothing of what they say. A thread of its own does the work.
class EventServer {
 public:
  static Result<EventServer> open(EventServerOptions options);
  EventServer(EventServer&&) noexcept;
  EventServer& operator=(EventServer&&) noexcept;
  ~EventServer();

  /// Of the first page, token and all.
  std::string url() const;

  std::vector<Happening> take();
  /// Does nothing where the client is gone.
  void send(ClientId client, std::string data);

 private:
  class Loop;
  explicit EventServer(std::unique_ptr<Loop> loop);
  std::unique_ptr<Loop> loop_;
};

}  // namespace texbrdf::web

#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "lsp/log.h"
#include "lsp/message_queue.h"
#include "lsp/session.h"
#include "source/result.h"
#include "web/event_server.h"

namespace texbrdf::lsp {

/// Joins the web server with the thread that answers the editor: what browsers say waits in the same queue.
class PreviewSite {
 public:
  /// `wake` may be called by any thread.
  static Result<PreviewSite> open(uint16_t port, std::function<void()> wake);

  /// The session can tell browsers things from then on. The site has to stay where it is, and outlive what it is told.
  void connect(Session& session, Log& log);
  /// Takes in what has happened, unless much waits already.
  void receive(MessageQueue& queue, Session& session);

 private:
  explicit PreviewSite(web::EventServer server) : server_(std::move(server)) {}

  web::EventServer server_;
};

}  // namespace texbrdf::lsp

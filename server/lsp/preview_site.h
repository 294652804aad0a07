#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

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
  /// Takes in what has happened, as long as little waits.
  void receive(MessageQueue& queue, Session& session);

 private:
  explicit PreviewSite(web::EventServer server) : server_(std::move(server)) {}

  void take_in(const web::Happening& happening, MessageQueue& queue, Session& session);
  void take_line(const web::Message& message, MessageQueue& queue);

  web::EventServer server_;
  std::vector<web::Happening> happenings_;  ///< the last that were taken
  std::size_t next_ = 0;                    ///< of them
  std::size_t line_begin_ = 0;              ///< in the next one, if it is a message
};

}  // namespace texbrdf::lsp

#include "lsp/preview_site.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <variant>

#include "pane/pages.h"

namespace texbrdf::lsp {
namespace {

/// With so many messages to be handled, those of browsers wait where they are bounded.
constexpr std::size_t kMostWaiting = 100;

}  // namespace

Result<PreviewSite> PreviewSite::open(uint16_t port, std::function<void()> wake) {
  auto server = web::EventServer::open({.port = port, .pages = pane::pages(), .wake = std::move(wake), .limits = {}});
  if (!server) return Failure{server.error()};
  return PreviewSite(*std::move(server));
}

void PreviewSite::connect(Session& session, Log& log) {
  session.browsers().connect(server_.url(),
                             [this](ViewerId browser, std::string body) { server_.send(browser, std::move(body)); });
  log.info(fmt::format("preview for browsers: {}", server_.url()));
  if (!pane::is_built()) log.warning("its page is not part of this program, which was built without Node");
}

void PreviewSite::receive(MessageQueue& queue, Session& session) {
  if (next_ == happenings_.size()) {
    happenings_ = server_.take();
    next_ = 0;
  }
  while (next_ < happenings_.size() && queue.size() < kMostWaiting) take_in(happenings_[next_], queue, session);
}

void PreviewSite::take_in(const web::Happening& happening, MessageQueue& queue, Session& session) {
  if (const auto* message = std::get_if<web::Message>(&happening)) return take_line(*message, queue);
  if (const auto* came = std::get_if<web::Connected>(&happening)) session.browser_came(came->client);
  if (const auto* gone = std::get_if<web::Gone>(&happening)) session.browser_went(gone->client);
  ++next_;
}

/// A body holds one message a line.
void PreviewSite::take_line(const web::Message& message, MessageQueue& queue) {
  const std::string_view rest = std::string_view(message.body).substr(line_begin_);
  const std::string_view line = rest.substr(0, rest.find('\n'));
  if (!line.empty()) queue.add_from(message.client, line);
  line_begin_ += line.size() + 1;
  if (line_begin_ < message.body.size()) return;
  line_begin_ = 0;
  ++next_;
}

}  // namespace texbrdf::lsp

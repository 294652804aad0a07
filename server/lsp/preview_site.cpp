#include "lsp/preview_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "pane/pages.h"

namespace texbrdf::lsp {
namespace {

/// With so many messages to be handled, those of browsers wait where they are bounded.
constexpr std::size_t kMostWaiting = 100;

/// A body holds one message a line.
void add_lines(MessageQueue& queue, ViewerId browser, std::string_view body) {
  while (!body.empty()) {
    const std::size_t end = std::min(body.find('\n'), body.size());
    if (end > 0) queue.add_from(browser, body.substr(0, end));
    body.remove_prefix(std::min(end + 1, body.size()));
  }
}

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
  if (queue.size() > kMostWaiting) return;
  for (web::Happening& happening : server_.take()) {
    if (const auto* came = std::get_if<web::Connected>(&happening)) session.browser_came(came->client);
    if (const auto* gone = std::get_if<web::Gone>(&happening)) session.browser_went(gone->client);
    if (const auto* message = std::get_if<web::Message>(&happening)) add_lines(queue, message->client, message->body);
  }
}

}  // namespace texbrdf::lsp

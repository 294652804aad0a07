#include "web/routes.h"

#include <charconv>

#include "web/access.h"

namespace texbrdf::web {
namespace {

constexpr unsigned kForbidden = 403;
constexpr unsigned kNotFound = 404;
constexpr unsigned kMethodNotAllowed = 405;
constexpr unsigned kUnsupportedMediaType = 415;

constexpr std::string_view kEventsPath = "events";
constexpr std::string_view kMessagesPath = "messages/";
/// No form of another site can send this type; a script of it would have to ask first.
constexpr std::string_view kMessageType = "application/json";

Route refused(unsigned status) {
  return {.kind = Route::Kind::Refused, .status = status};
}

bool is_from_here(const RequestHead& head, uint16_t port) {
  if (head.hosts.size() != 1 || !is_own_host(head.hosts.front(), port)) return false;
  return !head.origin || is_own_origin(*head.origin, port);
}

std::optional<ClientId> client_of(std::string_view digits) {
  ClientId client = 0;
  const char* const begin = digits.data();
  const char* const end = begin + digits.size();
  const auto read = std::from_chars(begin, end, client);
  if (digits.empty() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return client;
}

Route message_route(const RequestHead& head, std::string_view digits) {
  if (head.method != RequestHead::Method::Post) return refused(kMethodNotAllowed);
  if (head.content_type != kMessageType) return refused(kUnsupportedMediaType);
  const auto client = client_of(digits);
  return client ? Route{.kind = Route::Kind::Message, .client = *client} : refused(kNotFound);
}

}  // namespace

Route find_route(const RequestHead& head, const Site& site) {
  if (!is_from_here(head, site.port)) return refused(kForbidden);
  const auto path = path_behind_token(head.target, site.token);
  if (!path) return refused(kNotFound);
  if (path->starts_with(kMessagesPath)) return message_route(head, path->substr(kMessagesPath.size()));
  if (head.method != RequestHead::Method::Get) return refused(kMethodNotAllowed);
  if (*path == kEventsPath) return {.kind = Route::Kind::Events};
  for (const Page& page : site.pages) {
    if (page.path == *path) return {.kind = Route::Kind::Page, .page = &page};
  }
  return refused(kNotFound);
}

}  // namespace texbrdf::web

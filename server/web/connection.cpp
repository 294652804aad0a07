#include "web/connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <tuple>
#include <utility>

namespace texbrdf::web {
namespace {

namespace http = boost::beast::http;
using boost::asio::ip::tcp;

constexpr unsigned kHttp11 = 11;
constexpr unsigned kOk = 200;
constexpr unsigned kAccepted = 202;
constexpr unsigned kBadRequest = 400;
constexpr unsigned kNotFound = 404;
constexpr unsigned kPayloadTooLarge = 413;
constexpr unsigned kHeaderFieldsTooLarge = 431;
constexpr unsigned kServiceUnavailable = 503;
/// For a client that still writes when it has been refused: closing at once would lose the answer.
constexpr auto kGentleClose = std::chrono::seconds(1);

constexpr std::string_view kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

boost::string_view boosted(std::string_view text) {
  return {text.data(), text.size()};
}

std::string_view viewed(boost::string_view text) {
  return {text.data(), text.size()};
}

void add_common_fields(http::fields& fields) {
  fields.set("Content-Security-Policy", boosted(kContentSecurityPolicy));
  fields.set(http::field::x_frame_options, "DENY");
  fields.set(http::field::cache_control, "no-store");
  fields.set("X-Content-Type-Options", "nosniff");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("Cross-Origin-Opener-Policy", "same-origin");
  fields.set("Cross-Origin-Resource-Policy", "same-origin");
}

RequestHead::Method method_of(http::verb verb) {
  if (verb == http::verb::get) return RequestHead::Method::Get;
  return verb == http::verb::post ? RequestHead::Method::Post : RequestHead::Method::Other;
}

/// The status that answers what cannot be read; 0 where there is nobody to be answered.
unsigned status_of(const boost::system::error_code& error) {
  if (error == http::error::body_limit) return kPayloadTooLarge;
  if (error == http::error::header_limit || error == http::error::buffer_overflow) return kHeaderFieldsTooLarge;
  const bool has_ended = error == http::error::end_of_stream || error == http::error::partial_message;
  const bool is_of_http = error.category() == http::make_error_code(http::error::bad_method).category();
  return is_of_http && !has_ended ? kBadRequest : 0;
}

}  // namespace

Connection::Connection(tcp::socket socket, ServedSite& served)
    : served_(served), stream_(std::move(socket)), buffer_(served.limits.header_bytes + served.limits.message_bytes) {
  ++served_.connections;
}

Connection::~Connection() {
  --served_.connections;
}

void Connection::read_request() {
  parser_.emplace();
  parser_->header_limit(static_cast<uint32_t>(served_.limits.header_bytes));
  parser_->body_limit(served_.limits.message_bytes);
  stream_.expires_after(std::chrono::seconds(served_.limits.request_seconds));
  http::async_read_header(stream_, buffer_, *parser_, [self = shared_from_this()](const Error& error, std::size_t) {
    if (error) return self->refuse(error);
    self->head_arrived();
  });
}

RequestHead Connection::head() const {
  const auto& request = parser_->get();
  RequestHead head;
  head.method = method_of(request.method());
  head.target = viewed(request.target());
  const auto hosts = request.equal_range(http::field::host);
  for (auto host = hosts.first; host != hosts.second; ++host) head.hosts.push_back(viewed(host->value()));
  if (const auto origin = request.find(http::field::origin); origin != request.end()) {
    head.origin = viewed(origin->value());
  }
  head.content_type = viewed(request[http::field::content_type]);
  return head;
}

/// Of a request that is refused nothing more is read.
void Connection::head_arrived() {
  const Route route = find_route(head(), served_.site);
  const bool has_body = !parser_->is_done();
  switch (route.kind) {
    case Route::Kind::Refused:
      return refuse(route.status);
    case Route::Kind::Page:
      return has_body ? refuse(kBadRequest) : respond(kOk, route.page->content_type, route.page->body);
    case Route::Kind::Events:
      return has_body ? refuse(kBadRequest) : begin_stream();
    case Route::Kind::Message:
      return read_message(route.client);
  }
}

void Connection::read_message(ClientId client) {
  http::async_read(stream_, buffer_, *parser_, [self = shared_from_this(), client](const Error& error, std::size_t) {
    if (error) return self->refuse(error);
    self->take_message(client);
  });
}

void Connection::take_message(ClientId client) {
  if (!served_.streams.contains(client)) return refuse(kNotFound);
  if (served_.mailbox.is_full()) return refuse(kServiceUnavailable);
  served_.mailbox.add(Message{client, std::move(parser_->get().body())});
  respond(kAccepted, "text/plain", {});
}

void Connection::begin_stream() {
  if (served_.streams.size() >= served_.limits.streams || served_.mailbox.is_full()) return refuse(kServiceUnavailable);
  const ClientId client = ++served_.last_client;
  EventStream::Head head(http::status::ok, kHttp11);
  add_common_fields(head);
  head.set(http::field::content_type, "text/event-stream");
  head.keep_alive(false);
  stream_.expires_never();
  auto& stream = served_.streams[client];
  stream = std::make_shared<EventStream>(stream_.release_socket(), std::move(head), served_.limits.unsent_bytes,
                                         [&served = served_, client] {
                                           served.streams.erase(client);
                                           served.mailbox.add(Gone{client});
                                         });
  served_.mailbox.add(Connected{client});
  stream->start();
}

void Connection::respond(unsigned status, std::string_view content_type, std::string body) {
  response_.emplace(http::int_to_status(status), kHttp11);
  add_common_fields(*response_);
  response_->set(http::field::content_type, boosted(content_type));
  response_->keep_alive(parser_->is_done() && parser_->get().keep_alive() && status < kBadRequest);
  response_->body() = std::move(body);
  response_->prepare_payload();
  http::async_write(stream_, *response_, [self = shared_from_this()](const Error& error, std::size_t) {
    if (error) return;
    if (self->response_->keep_alive()) return self->read_request();
    self->close_gently();
  });
}

void Connection::refuse(unsigned status) {
  respond(status, "text/plain", std::string(viewed(http::obsolete_reason(http::int_to_status(status)))) + "\n");
}

void Connection::refuse(const Error& error) {
  if (const unsigned status = status_of(error); status != 0) refuse(status);
}

void Connection::close_gently() {
  Error ignored;
  std::ignore = stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  stream_.expires_after(kGentleClose);
  drain();
}

void Connection::drain() {
  stream_.async_read_some(boost::asio::buffer(unread_), [self = shared_from_this()](const Error& error, std::size_t) {
    if (!error) self->drain();
  });
}

}  // namespace texbrdf::web

#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "web/event_server.h"
#include "web/event_stream.h"
#include "web/mailbox.h"
#include "web/routes.h"

namespace texbrdf::web {

/// What the connections of a server have in common. Belongs to the server's thread, but for the mailbox.
struct ServedSite {
  ServedSite(Site served, const EventServerLimits& bounds, std::function<void()> wake)
      : site(std::move(served)), limits(bounds), mailbox(std::move(wake), bounds.mailbox) {}

  Site site;
  EventServerLimits limits;
  Mailbox mailbox;
  std::size_t connections = 0;
  ClientId last_client = 0;
  std::map<ClientId, std::shared_ptr<EventStream>> streams;
};

/// Answers the requests of one connection, one after the other, until one of them becomes a stream of events.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, ServedSite& served);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void read_request();

 private:
  using Error = boost::system::error_code;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;

  void head_arrived();
  RequestHead head() const;
  void read_message(ClientId client);
  void take_message(ClientId client);
  void begin_stream();
  void respond(unsigned status, std::string_view content_type, std::string body);
  void refuse(unsigned status);
  void refuse(const Error& error);
  void close_gently();
  void drain();

  ServedSite& served_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  std::optional<Response> response_;
  std::array<char, 4096> unread_{};  ///< what still comes behind a refusal
};

}  // namespace texbrdf::web

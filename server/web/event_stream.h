#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/serializer.hpp>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace texbrdf::web {

/// Server-sent events to one client, for as long as it listens. Belongs to the thread of its socket.
class EventStream : public std::enable_shared_from_this<EventStream> {
 public:
  using Head = boost::beast::http::response<boost::beast::http::empty_body>;

  /// `on_end` is called once, when the client is gone or reads too slowly.
  EventStream(boost::asio::ip::tcp::socket socket, Head head, std::size_t max_unsent, std::function<void()> on_end);

  void start();
  void send(std::string_view data);
  void end();

 private:
  void write_next();
  void watch();

  boost::asio::ip::tcp::socket socket_;
  Head head_;
  boost::beast::http::response_serializer<boost::beast::http::empty_body> serializer_;
  std::size_t max_unsent_;
  std::function<void()> on_end_;
  std::deque<std::string> unsent_;
  std::size_t unsent_bytes_ = 0;
  bool writing_ = true;  ///< the head comes first
  std::array<char, 1> nothing_{};
};

/// How data stands in the stream: each of its lines behind `data: `, and an empty line.
std::string event_text(std::string_view data);

}  // namespace texbrdf::web

#include "web/event_stream.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/write.hpp>
#include <tuple>
#include <utility>

namespace texbrdf::web {

using Error = boost::system::error_code;

EventStream::EventStream(boost::asio::ip::tcp::socket socket, Head head, std::size_t max_unsent,
                         std::function<void()> on_end)
    : socket_(std::move(socket)),
      head_(std::move(head)),
      serializer_(head_),
      max_unsent_(max_unsent),
      on_end_(std::move(on_end)) {}

void EventStream::start() {
  watch();
  boost::beast::http::async_write_header(socket_, serializer_,
                                         [self = shared_from_this()](const Error& error, std::size_t) {
                                           self->writing_ = false;
                                           if (error) return self->end();
                                           self->write_next();
                                         });
}

void EventStream::send(std::string_view data) {
  unsent_.push_back(event_text(data));
  unsent_bytes_ += unsent_.back().size();
  if (unsent_bytes_ > max_unsent_) return end();
  if (!writing_) write_next();
}

void EventStream::write_next() {
  if (unsent_.empty()) return;
  writing_ = true;
  boost::asio::async_write(socket_, boost::asio::buffer(unsent_.front()),
                           [self = shared_from_this()](const Error& error, std::size_t bytes) {
                             self->writing_ = false;
                             if (error) return self->end();
                             self->unsent_bytes_ -= bytes;
                             self->unsent_.pop_front();
                             self->write_next();
                           });
}

/// The client has nothing more to say on this connection: whatever comes, it is its end.
void EventStream::watch() {
  socket_.async_read_some(boost::asio::buffer(nothing_),
                          [self = shared_from_this()](const Error&, std::size_t) { self->end(); });
}

void EventStream::end() {
  if (!on_end_) return;
  Error ignored;
  std::ignore = socket_.shutdown(boost::asio::ip::tcp::socket::shutdown_both, ignored);
  std::ignore = socket_.close(ignored);
  std::exchange(on_end_, {})();
}

std::string event_text(std::string_view data) {
  std::string text;
  text.reserve(data.size() + 16);
  while (true) {
    const std::size_t end = data.find('\n');
    text.append("data: ").append(data.substr(0, end)).append("\n");
    if (end == std::string_view::npos) break;
    data.remove_prefix(end + 1);
  }
  return text.append("\n");
}

}  // namespace texbrdf::web

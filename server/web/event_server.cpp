#include "web/event_server.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <thread>
#include <tuple>
#include <utility>

#include "web/access.h"
#include "web/connection.h"

namespace texbrdf::web {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Error = boost::system::error_code;

/// When no more can be accepted, as for want of descriptors.
constexpr auto kPauseAfterFailure = std::chrono::milliseconds(200);

/// The process that draws pictures must not keep a connection open.
void keep_from_children(int descriptor) {
  fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

void prepare(tcp::socket& socket) {
  keep_from_children(socket.native_handle());
  Error ignored;  // only slower
  std::ignore = socket.set_option(tcp::no_delay(true), ignored);
}

Error listen_on_loopback(tcp::acceptor& acceptor, uint16_t port) {
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  Error error;
  if (acceptor.open(endpoint.protocol(), error)) return error;
  keep_from_children(acceptor.native_handle());
  if (acceptor.set_option(tcp::acceptor::reuse_address(true), error)) return error;
  if (acceptor.bind(endpoint, error)) return error;
  return acceptor.listen(tcp::acceptor::max_listen_connections, error);
}

}  // namespace

/// The thread and what belongs to it.
class EventServer::Loop {
 public:
  Loop(EventServerOptions options, std::string token)
      : served_({.port = 0, .token = std::move(token), .pages = std::move(options.pages)}, options.limits,
                std::move(options.wake)) {}
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  Error start(uint16_t port);
  const Site& site() const { return served_.site; }
  Mailbox& mailbox() { return served_.mailbox; }
  void send(ClientId client, std::string data);

 private:
  void run();
  void accept();
  void accept_later();

  ServedSite served_;
  asio::io_context io_{1};  // behind what its handlers refer to
  tcp::acceptor acceptor_{io_};
  asio::steady_timer pause_{io_};
  std::thread thread_;
};

Error EventServer::Loop::start(uint16_t port) {
  if (const Error error = listen_on_loopback(acceptor_, port)) return error;
  Error error;
  served_.site.port = acceptor_.local_endpoint(error).port();
  if (error) return error;
  accept();
  thread_ = std::thread([this] { run(); });
  return {};
}

/// What fails, as for want of memory, takes its own connection down and no other.
void EventServer::Loop::run() {
  while (!io_.stopped()) {
    try {
      io_.run();
    } catch (const std::exception&) {
      continue;
    }
  }
}

EventServer::Loop::~Loop() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
  served_.streams.clear();
}

void EventServer::Loop::accept() {
  acceptor_.async_accept([this](const Error& error, tcp::socket socket) {
    if (error) return accept_later();
    accept();
    prepare(socket);
    if (served_.connections + served_.streams.size() < served_.limits.connections) {
      std::make_shared<Connection>(std::move(socket), served_)->read_request();
    }
  });
}

void EventServer::Loop::accept_later() {
  pause_.expires_after(kPauseAfterFailure);
  pause_.async_wait([this](const Error& error) {
    if (!error) accept();
  });
}

void EventServer::Loop::send(ClientId client, std::string data) {
  asio::post(io_, [this, client, data = std::move(data)] {
    const auto found = served_.streams.find(client);
    if (found == served_.streams.end()) return;
    const std::shared_ptr<EventStream> stream = found->second;  // `send` may end it
    stream->send(data);
  });
}

Result<EventServer> EventServer::open(EventServerOptions options) {
  auto token = make_token();
  if (!token) return Failure{"the system has no random numbers"};
  const uint16_t port = options.port;
  auto loop = std::make_unique<Loop>(std::move(options), *std::move(token));
  if (const Error error = loop->start(port)) return Failure{fmt::format("port {}: {}", port, error.message())};
  return EventServer(std::move(loop));
}

EventServer::EventServer(std::unique_ptr<Loop> loop) : loop_(std::move(loop)) {}
EventServer::EventServer(EventServer&&) noexcept = default;
EventServer& EventServer::operator=(EventServer&&) noexcept = default;
EventServer::~EventServer() = default;

std::string EventServer::url() const {
  return fmt::format("http://127.0.0.1:{}/{}/", loop_->site().port, loop_->site().token);
}

std::vector<Happening> EventServer::take() {
  return loop_->mailbox().take();
}

void EventServer::send(ClientId client, std::string data) {
  loop_->send(client, std::move(data));
}

}  // namespace texbrdf::web

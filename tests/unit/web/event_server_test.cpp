#include "web/event_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "web/event_stream.h"

namespace texbrdf::web {
namespace {

constexpr int kPatienceMs = 10000;

/// A browser's end of a connection.
class Socket {
 public:
  explicit Socket(uint16_t port) : fd_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Socket() { leave(); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void write(std::string_view text) const {
    EXPECT_EQ(::send(fd_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  /// What comes until the text ends so, or all until the server closes.
  std::string read_until(std::string_view end) const {
    std::string text;
    pollfd ready{fd_, POLLIN, 0};
    while (end.empty() || !text.ends_with(end)) {
      char byte = 0;
      if (poll(&ready, 1, kPatienceMs) <= 0) return text + "[nothing more in time]";
      if (::read(fd_, &byte, 1) <= 0) break;
      text += byte;
    }
    return text;
  }
  void leave() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

class EventServerTest : public testing::Test {
 protected:
  void open(EventServerLimits limits = {}) {
    auto server =
        EventServer::open({.port = 0, .pages = {{"", "text/html", "the page"}}, .wake = [] {}, .limits = limits});
    ASSERT_TRUE(server) << server.error();
    server_.emplace(*std::move(server));
    const std::string url = server_->url();
    const std::size_t port_at = url.find(':', 7) + 1;
    const std::size_t token_at = url.find('/', port_at) + 1;
    port_ = static_cast<uint16_t>(std::stoi(url.substr(port_at)));
    token_ = url.substr(token_at, url.size() - 1 - token_at);
  }
  std::string head(std::string_view method, std::string_view path, std::string_view more = {}) const {
    return std::string(method) + " /" + token_ + "/" + std::string(path) +
           " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n" + std::string(more) + "\r\n";
  }
  std::string post(ClientId client, std::string_view body) const {
    return head("POST", "messages/" + std::to_string(client),
                "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n") +
           std::string(body);
  }
  /// The status line of what answers a request on a connection of its own.
  std::string status(std::string_view request) const {
    const Socket socket(port_);
    socket.write(request);
    return socket.read_until("\r\n");
  }
  template <typename T>
  T next() {
    for (int waited = 0; waited < kPatienceMs; ++waited) {
      if (happenings_.empty()) happenings_ = server_->take();
      if (!happenings_.empty()) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (happenings_.empty() || !std::holds_alternative<T>(happenings_.front())) {
      ADD_FAILURE() << "something else happened, or nothing";
      return {};
    }
    T found = std::get<T>(std::move(happenings_.front()));
    happenings_.erase(happenings_.begin());
    return found;
  }

  std::optional<EventServer> server_;
  std::vector<Happening> happenings_;
  uint16_t port_ = 0;
  std::string token_;
};

TEST_F(EventServerTest, ThePageComesWithItsPolicy) {
  open();
  const Socket socket(port_);
  socket.write(head("GET", ""));
  const std::string text = socket.read_until("the page");
  EXPECT_TRUE(text.starts_with("HTTP/1.1 200 OK\r\n")) << text;
  EXPECT_NE(text.find("Content-Security-Policy: default-src 'none'; script-src 'self';"), std::string::npos) << text;
  EXPECT_NE(text.find("Referrer-Policy: no-referrer\r\n"), std::string::npos);
  EXPECT_NE(text.find("X-Content-Type-Options: nosniff\r\n"), std::string::npos);
  EXPECT_EQ(text.find("Access-Control"), std::string::npos);
  socket.write(head("GET", ""));
  EXPECT_TRUE(socket.read_until("the page").starts_with("HTTP/1.1 200 OK\r\n"))
      << "a second request on the same connection";
}

TEST_F(EventServerTest, WhatIsWrittenAtAClientReachesItInOrder) {
  open();
  const Socket stream(port_);
  stream.write(head("GET", "events"));
  const ClientId client = next<Connected>().client;
  const std::string first = stream.read_until("\r\n\r\n");
  EXPECT_NE(first.find("Content-Type: text/event-stream\r\n"), std::string::npos) << first;
  server_->send(client, "one");
  server_->send(client + 1, "for nobody");
  server_->send(client, "two\nlines");
  EXPECT_EQ(stream.read_until("lines\n\n"), "data: one\n\ndata: two\ndata: lines\n\n");
}

TEST_F(EventServerTest, MessagesArriveAndAClientThatLeavesIsGone) {
  open();
  Socket stream(port_);
  stream.write(head("GET", "events"));
  const ClientId client = next<Connected>().client;
  EXPECT_EQ(status(post(client, "hello")), "HTTP/1.1 202 Accepted\r\n");
  const Message message = next<Message>();
  EXPECT_EQ(message.client, client);
  EXPECT_EQ(message.body, "hello");
  stream.leave();
  EXPECT_EQ(next<Gone>().client, client);
  EXPECT_EQ(status(post(client, "hello")), "HTTP/1.1 404 Not Found\r\n");
}

TEST_F(EventServerTest, SeveralClientsAreToldApart) {
  open();
  const Socket one(port_);
  one.write(head("GET", "events"));
  const ClientId first = next<Connected>().client;
  const Socket other(port_);
  other.write(head("GET", "events"));
  const ClientId second = next<Connected>().client;
  EXPECT_NE(first, second);
  server_->send(second, "to the second");
  server_->send(first, "to the first");
  EXPECT_TRUE(one.read_until("first\n\n").ends_with("\r\n\r\ndata: to the first\n\n"));
  EXPECT_TRUE(other.read_until("second\n\n").ends_with("\r\n\r\ndata: to the second\n\n"));
}

TEST_F(EventServerTest, OtherNamesAndTokensAreRefused) {
  open();
  EXPECT_EQ(status("GET /" + token_ + "/ HTTP/1.1\r\nHost: evil.example:" + std::to_string(port_) + "\r\n\r\n"),
            "HTTP/1.1 403 Forbidden\r\n");
  EXPECT_EQ(status("GET /" + token_ + "/ HTTP/1.0\r\n\r\n"), "HTTP/1.1 403 Forbidden\r\n");
  EXPECT_EQ(status(head("GET", "", "Origin: http://evil.example\r\n")), "HTTP/1.1 403 Forbidden\r\n");
  token_.back() = token_.back() == '0' ? '1' : '0';
  EXPECT_EQ(status(head("GET", "")), "HTTP/1.1 404 Not Found\r\n");
}

TEST_F(EventServerTest, WhatIsTooLargeIsRefused) {
  open({.header_bytes = 512, .message_bytes = 100});
  EXPECT_EQ(status(head("GET", "", "X: " + std::string(1000, 'x') + "\r\n")),
            "HTTP/1.1 431 Request Header Fields Too Large\r\n");
  EXPECT_EQ(status(post(1, std::string(101, 'x'))), "HTTP/1.1 413 Payload Too Large\r\n");
  EXPECT_EQ(status("no request at all\r\n\r\n"), "HTTP/1.1 400 Bad Request\r\n");
  EXPECT_EQ(status(head("GET", "", "Content-Length: 3\r\n") + "abc"), "HTTP/1.1 400 Bad Request\r\n");
}

TEST_F(EventServerTest, StreamsAreCounted) {
  open({.streams = 1});
  Socket one(port_);
  one.write(head("GET", "events"));
  next<Connected>();
  EXPECT_EQ(status(head("GET", "events")), "HTTP/1.1 503 Service Unavailable\r\n");
  one.leave();
  next<Gone>();
  EXPECT_EQ(status(head("GET", "events")), "HTTP/1.1 200 OK\r\n");
}

TEST_F(EventServerTest, ConnectionsAreCounted) {
  open({.connections = 2});
  Socket one(port_);
  const Socket two(port_);
  one.write(head("GET", ""));
  one.read_until("the page");
  two.write(head("GET", ""));
  two.read_until("the page");
  EXPECT_EQ(Socket(port_).read_until(""), "");
  one.leave();
  std::string line = status(head("GET", ""));
  for (int tries = 0; line.empty() && tries < kPatienceMs; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    line = status(head("GET", ""));
  }
  EXPECT_EQ(line, "HTTP/1.1 200 OK\r\n");
}

TEST_F(EventServerTest, MessagesThatNobodyTakesPileUpToALimit) {
  open({.mailbox = {.happenings = 3, .bytes = 1000}});
  const Socket stream(port_);
  stream.write(head("GET", "events"));
  stream.read_until("\r\n\r\n");
  EXPECT_EQ(status(post(1, "a")), "HTTP/1.1 202 Accepted\r\n");
  EXPECT_EQ(status(post(1, "b")), "HTTP/1.1 202 Accepted\r\n");
  EXPECT_EQ(status(post(1, "c")), "HTTP/1.1 503 Service Unavailable\r\n");
  server_->take();
  EXPECT_EQ(status(post(1, std::string(1000, 'd'))), "HTTP/1.1 202 Accepted\r\n");
  EXPECT_EQ(status(post(1, "e")), "HTTP/1.1 503 Service Unavailable\r\n");
}

TEST_F(EventServerTest, AClientThatDoesNotReadIsCutOff) {
  open({.unsent_bytes = 1000});
  const Socket stream(port_);
  stream.write(head("GET", "events"));
  const ClientId client = next<Connected>().client;
  server_->send(client, std::string(2000, 'x'));
  EXPECT_EQ(next<Gone>().client, client);
}

TEST_F(EventServerTest, WhoSaysNothingIsCutOff) {
  open({.request_seconds = 1});
  const Socket idle(port_);
  idle.write("GET /");
  EXPECT_EQ(idle.read_until(""), "");
}

TEST_F(EventServerTest, TheEndOfTheServerEndsItsStreams) {
  open();
  const Socket stream(port_);
  stream.write(head("GET", "events"));
  stream.read_until("\r\n\r\n");
  server_.reset();
  EXPECT_EQ(stream.read_until(""), "");
}

TEST_F(EventServerTest, APortThatIsTakenIsToldOf) {
  open();
  const auto other = EventServer::open({.port = port_, .pages = {}, .wake = [] {}});
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().find(std::to_string(port_)), std::string::npos) << other.error();
}

TEST(EventText, EachLineIsMarked) {
  EXPECT_EQ(event_text(""), "data: \n\n");
  EXPECT_EQ(event_text("a\n\nb"), "data: a\ndata: \ndata: b\n\n");
}

}  // namespace
}  // namespace texbrdf::web

#include "lsp/fd_channel.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

namespace texbrdf::lsp {
namespace {

/// The client's ends of two pipes and the channel at the other ends.
class FdChannelTest : public testing::Test {
 protected:
  FdChannelTest() {
    std::array<int, 2> to_server{};
    std::array<int, 2> to_client{};
    if (pipe(to_server.data()) != 0 || pipe(to_client.data()) != 0) throw std::runtime_error("no pipes");
    server_input_ = to_server[0];
    client_output_ = to_server[1];
    client_input_ = to_client[0];
    server_output_ = to_client[1];
    channel_.emplace(server_input_, server_output_);
  }
  ~FdChannelTest() override {
    channel_.reset();
    close(server_input_);
    close(server_output_);
    close_client_input();
    close_client_output();
  }
  void close_client_output() {
    if (client_output_ >= 0) close(client_output_);
    client_output_ = -1;
  }
  void close_client_input() {
    if (client_input_ >= 0) close(client_input_);
    client_input_ = -1;
  }
  void client_writes(std::string_view bytes) {
    ASSERT_EQ(write(client_output_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  std::string client_reads(std::size_t most) {
    std::string bytes(most, '\0');
    const ssize_t count = ::read(client_input_, bytes.data(), most);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  int server_input_ = -1;
  int server_output_ = -1;
  int client_input_ = -1;
  int client_output_ = -1;
  std::optional<FdChannel> channel_;
};

using Status = Channel::Status;

TEST_F(FdChannelTest, ReadsWhatIsThere) {
  std::string buffer = "<";
  EXPECT_EQ(channel_->read(buffer, 0), Status::Idle);
  client_writes("hello");
  EXPECT_EQ(channel_->read(buffer, Channel::kForever), Status::Data);
  EXPECT_EQ(buffer, "<hello");
  close_client_output();
  EXPECT_EQ(channel_->read(buffer, Channel::kForever), Status::Closed);
  EXPECT_EQ(channel_->read(buffer, 0), Status::Closed);
}

TEST_F(FdChannelTest, AClientThatDoesNotReadIsStillRead) {
  const std::string large(1 << 20, 'x');
  channel_->write(large);
  client_writes("more");
  std::string buffer;
  EXPECT_EQ(channel_->read(buffer, Channel::kForever), Status::Data);
  EXPECT_EQ(buffer, "more");

  std::string received;
  while (received.size() < large.size()) {
    received += client_reads(large.size());
    EXPECT_EQ(channel_->read(buffer, 0), Status::Idle);
  }
  EXPECT_EQ(received, large);
}

TEST_F(FdChannelTest, RepliesStillArriveAfterTheInputEnded) {
  close_client_output();
  std::string buffer;
  EXPECT_EQ(channel_->read(buffer, Channel::kForever), Status::Closed);
  channel_->write("bye");
  channel_->flush();
  EXPECT_EQ(client_reads(10), "bye");
}

TEST_F(FdChannelTest, AClientThatIsGoneClosesTheChannel) {
  close_client_input();
  channel_->write("lost");
  std::string buffer;
  EXPECT_EQ(channel_->read(buffer, Channel::kForever), Status::Closed);
  channel_->flush();
}

}  // namespace
}  // namespace texbrdf::lsp

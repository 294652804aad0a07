#include "render/channel.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <thread>

namespace texbrdf::render {
namespace {

using namespace std::chrono_literals;

class Channel : public testing::Test {
 protected:
  void SetUp() override {
    std::array<int, 2> ends{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
    near_ = ends[0];
    far_ = ends[1];
  }
  void TearDown() override {
    close(near_);
    close_far();
  }
  void close_far() {
    if (far_ >= 0) close(far_);
    far_ = -1;
  }
  ChannelFaultKind fault_of_receiving(std::chrono::milliseconds patience = 1000ms) const {
    const auto received = receive_message(near_, Clock::now() + patience);
    const auto* fault = std::get_if<ChannelFault>(&received);
    EXPECT_NE(fault, nullptr);
    return fault->kind;
  }
  void send_header(uint32_t mark, uint32_t kind, uint32_t length) const {
    const std::array<uint32_t, 3> header{mark, kind, length};
    ASSERT_EQ(write(far_, header.data(), sizeof header), static_cast<ssize_t>(sizeof header));
  }

  static constexpr uint32_t kMark = 0x52425854;
  int near_ = -1;
  int far_ = -1;
};

TEST_F(Channel, CarriesMessagesLargerThanItsBuffer) {
  std::vector<uint8_t> payload(5'000'000);
  for (std::size_t i = 0; i < payload.size(); ++i) payload[i] = static_cast<uint8_t>(i * 7);
  std::thread sender([&] { EXPECT_EQ(send_message(far_, 3, payload, Clock::now() + 10s).index(), 0U); });
  const auto received = receive_message(near_, Clock::now() + 10s);
  sender.join();
  const auto* message = std::get_if<Message>(&received);
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->kind, 3U);
  EXPECT_EQ(message->payload, payload);
}

TEST_F(Channel, PutsPiecesTogether) {
  std::thread sender([&] {
    const std::array<uint32_t, 4> whole{kMark, 5, 4, 0x01020304};
    const auto* bytes = reinterpret_cast<const uint8_t*>(whole.data());
    for (std::size_t i = 0; i < sizeof whole; ++i) {
      EXPECT_EQ(write(far_, bytes + i, 1), 1);
      std::this_thread::sleep_for(1ms);
    }
  });
  const auto received = receive_message(near_, Clock::now() + 10s);
  sender.join();
  const auto* message = std::get_if<Message>(&received);
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->kind, 5U);
  EXPECT_EQ(message->payload, (std::vector<uint8_t>{4, 3, 2, 1}));
}

TEST_F(Channel, AnswersWithinTheDeadlineToSilence) {
  const auto start = Clock::now();
  EXPECT_EQ(fault_of_receiving(30ms), ChannelFaultKind::Deadline);
  EXPECT_LT(Clock::now() - start, 5s);
}

TEST_F(Channel, AnswersWithinTheDeadlineWhereNobodyReads) {
  const std::vector<uint8_t> payload(8'000'000);
  const auto sent = send_message(near_, 1, payload, Clock::now() + 30ms);
  const auto* fault = std::get_if<ChannelFault>(&sent);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->kind, ChannelFaultKind::Deadline);
}

TEST_F(Channel, AMessageThatStopsHalfwayMeetsTheDeadline) {
  send_header(kMark, 1, 100);
  EXPECT_EQ(fault_of_receiving(30ms), ChannelFaultKind::Deadline);
}

TEST_F(Channel, TellsGarbage) {
  send_header(0x12345678, 1, 0);
  EXPECT_EQ(fault_of_receiving(), ChannelFaultKind::Garbage);
}

TEST_F(Channel, TellsALengthThatIsNone) {
  send_header(kMark, 1, kMaxPayloadBytes + 1);
  EXPECT_EQ(fault_of_receiving(), ChannelFaultKind::Garbage);
}

TEST_F(Channel, AClosedEndIsNoSignal) {
  close_far();
  EXPECT_EQ(fault_of_receiving(), ChannelFaultKind::Closed);
  const auto sent = send_message(near_, 1, {}, Clock::now() + 1s);
  const auto* fault = std::get_if<ChannelFault>(&sent);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->kind, ChannelFaultKind::Closed);
}

TEST_F(Channel, AnEndThatClosesHalfwayIsTold) {
  send_header(kMark, 1, 100);
  close_far();
  EXPECT_EQ(fault_of_receiving(), ChannelFaultKind::Closed);
}

}  // namespace
}  // namespace texbrdf::render

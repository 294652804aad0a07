#include "lsp/framing.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace texbrdf::lsp {
namespace {

/// Bodies as they are, problems with a `!` before them.
std::vector<std::string> take_all(FrameDecoder& decoder) {
  std::vector<std::string> taken;
  while (auto next = decoder.next()) {
    if (const auto* problem = std::get_if<FramingProblem>(&*next)) {
      taken.push_back("!" + problem->message);
    } else {
      taken.emplace_back(std::get<Frame>(*next).body);
    }
  }
  return taken;
}

std::vector<std::string> decode(std::string_view stream) {
  FrameDecoder decoder;
  decoder.input() += stream;
  return take_all(decoder);
}

using Bodies = std::vector<std::string>;

TEST(Framing, FrameIsReadBack) {
  EXPECT_EQ(frame("{}"), "Content-Length: 2\r\n\r\n{}");
  EXPECT_EQ(decode(frame("{}") + frame("") + frame("[1]")), (Bodies{"{}", "", "[1]"}));
}

TEST(Framing, OtherFieldsAndSpellingsOfTheNameAreAccepted) {
  EXPECT_EQ(decode("Content-Type: application/vscode-jsonrpc; charset=utf-8\r\nContent-Length: 2\r\n\r\n{}"),
            Bodies{"{}"});
  EXPECT_EQ(decode("content-length:2\r\nX: \xff\r\n\r\n{}"), Bodies{"{}"});
  EXPECT_EQ(decode("Content-Length: 2\n\n{}"), Bodies{"{}"});
}

TEST(Framing, OneByteAtATime) {
  const std::string stream = frame("{\"a\":1}") + frame("{}");
  FrameDecoder decoder;
  Bodies taken;
  for (const char byte : stream) {
    decoder.input() += byte;
    for (std::string& body : take_all(decoder)) taken.push_back(std::move(body));
  }
  EXPECT_EQ(taken, (Bodies{"{\"a\":1}", "{}"}));
  EXPECT_FALSE(decoder.inside_message());
}

TEST(Framing, HalfAMessageIsWaitedFor) {
  FrameDecoder decoder;
  decoder.input() += "Content-Length: 10\r\n\r\n{";
  EXPECT_EQ(take_all(decoder), Bodies{});
  EXPECT_TRUE(decoder.inside_message());
}

TEST(Framing, AfterABrokenHeaderTheNextMessageIsFound) {
  const std::string good = frame("{}");
  EXPECT_EQ(decode("hello\r\n\r\n" + good), (Bodies{"!no header field: hello", "{}"}));
  EXPECT_EQ(decode("c\":1}" + good), (Bodies{"!no header field: c\":1}Content-Length: 2", "{}"}));
  EXPECT_EQ(decode("Content-Type: x\r\n\r\n{\"lost\":1}" + good), (Bodies{"!header without Content-Length", "{}"}));
  EXPECT_EQ(decode("Content-Length: -5\r\n\r\nxxxxx" + good),
            (Bodies{"!Content-Length is no natural number: -5", "{}"}));
  EXPECT_EQ(decode("Content-Length: 5x\r\n\r\nxxxxx" + good),
            (Bodies{"!Content-Length is no natural number: 5x", "{}"}));
  EXPECT_EQ(decode("Content-Length:\r\n\r\n" + good), (Bodies{"!Content-Length is no natural number: ", "{}"}));
  EXPECT_EQ(decode("Content-Length: 99999999999999999999999\r\n\r\nx" + good),
            (Bodies{"!Content-Length is no natural number: 99999999999999999999999", "{}"}));
}

TEST(Framing, AMessageOverTheLimitIsNotStored) {
  FrameDecoder decoder(10);
  decoder.input() += "Content-Length: 11\r\n\r\n";
  EXPECT_EQ(take_all(decoder), Bodies{"!a message of 11 bytes is longer than 10"});
  for (int i = 0; i < 1000; ++i) {
    decoder.input() += std::string(1000, 'x');
    EXPECT_EQ(take_all(decoder), Bodies{});
    ASSERT_LT(decoder.input().size(), 2000u);
  }
  decoder.input() += frame("0123456789");
  EXPECT_EQ(take_all(decoder), Bodies{"0123456789"});
}

TEST(Framing, AHeaderWithoutEndIsNotStored) {
  FrameDecoder decoder;
  Bodies taken;
  for (int i = 0; i < 1000; ++i) {
    decoder.input() += std::string(1000, 'x');
    for (std::string& body : take_all(decoder)) taken.push_back(std::move(body));
    ASSERT_LT(decoder.input().size(), 2 * kMaxHeaderBytes);
  }
  EXPECT_EQ(taken, Bodies{"!no end of the header within 16384 bytes"});
}

TEST(Framing, ManyMessagesInOneBufferCostTheSameEach) {
  FrameDecoder decoder;
  for (int i = 0; i < 20000; ++i) decoder.input() += frame("{\"n\":1}");
  EXPECT_EQ(take_all(decoder).size(), 20000u);
  EXPECT_TRUE(decoder.input().empty());
}

}  // namespace
}  // namespace texbrdf::lsp

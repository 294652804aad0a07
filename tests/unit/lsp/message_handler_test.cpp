#include "lsp/message_handler.h"

#include <gtest/gtest.h>

#include <new>
#include <string>
#include <vector>

namespace texbrdf::lsp {
namespace {

/// Methods that fail as no method should.
struct Faulty {
  std::optional<ResponseError> broken_invariant(const NoParams&, JsonWriter& result) {
    result.begin_object();
    throw InternalError("the invariant is broken");
  }
  std::optional<ResponseError> out_of_memory(const NoParams&, JsonWriter&) { throw std::bad_alloc(); }
  std::string notification(const NoParams&) { throw InternalError("another invariant"); }
};

class MessageHandlerTest : public testing::Test {
 protected:
  MessageHandlerTest() {
    session_.bind_methods(methods_);
    methods_.request("test/brokenInvariant", faulty_, &Faulty::broken_invariant);
    methods_.request("test/outOfMemory", faulty_, &Faulty::out_of_memory);
    methods_.notification("test/notification", faulty_, &Faulty::notification);
    send(R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"capabilities":{}}})");
    replies_.clear();
  }
  void send(const std::string& body) { handler_.handle({parse_message(body), 0, false}); }
  void open(const std::string& uri) {
    send(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" + uri +
         R"(","languageId":"latex","version":1,"text":"\\begin{equation}f = a\\end{equation}\n)"
         R"(\\begin{equation}a = 1\\end{equation}"}}})");
    publish();
  }
  /// In the second equation, `1` by `23`.
  void edit(const std::string& uri) {
    send(R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":")" + uri +
         R"(","version":2},"contentChanges":[{"range":{"start":{"line":1,"character":20},)"
         R"("end":{"line":1,"character":21}},"text":"2"},{"range":{"start":{"line":1,"character":21},)"
         R"("end":{"line":1,"character":21}},"text":"3"}]}})");
  }
  /// As the server does while no message waits.
  void publish() {
    while (handler_.has_publications()) handler_.publish_next();
  }
  bool last_reply_has(std::string_view part) const { return replies_.back().find(part) != std::string::npos; }

  std::string log_lines_;
  std::vector<std::string> replies_;
  Log log_{LogLevel::Error, [this](std::string_view line) { log_lines_ += line.substr(line.find(']') + 2); }};
  Faulty faulty_;
  ClientProcess client_process_{process_exists};
  Session session_{log_, client_process_, "", ""};
  Dispatcher methods_;
  /// What holds this cannot be sent.
  std::string unsendable_;
  MessageHandler handler_{session_, methods_, log_, [this](const std::string& body) {
                            require(unsendable_.empty() || body.find(unsendable_) == std::string::npos, "unsendable");
                            replies_.push_back(body);
                          }};
};

TEST_F(MessageHandlerTest, AFaultInAHandlerIsAnErrorReplyAndALogLine) {
  send(R"({"jsonrpc":"2.0","id":1,"method":"test/brokenInvariant"})");
  send(R"({"jsonrpc":"2.0","id":2,"method":"test/outOfMemory"})");
  ASSERT_EQ(replies_.size(), 2u);
  EXPECT_EQ(replies_[0], R"({"jsonrpc":"2.0","id":1,"error":{"code":-32603,"message":"the invariant is broken"}})");
  EXPECT_EQ(replies_[1], R"({"jsonrpc":"2.0","id":2,"error":{"code":-32603,"message":"std::bad_alloc"}})");
  EXPECT_EQ(log_lines_,
            "error   internal error in test/brokenInvariant: the invariant is broken\n"
            "error   internal error in test/outOfMemory: std::bad_alloc\n");
}

TEST_F(MessageHandlerTest, AFaultInANotificationIsALogLine) {
  send(R"({"jsonrpc":"2.0","method":"test/notification"})");
  EXPECT_TRUE(replies_.empty());
  EXPECT_EQ(log_lines_, "error   internal error in test/notification: another invariant\n");
  send(R"({"jsonrpc":"2.0","id":3,"method":"shutdown"})");
  ASSERT_EQ(replies_.size(), 1u);
  EXPECT_EQ(replies_[0], R"({"jsonrpc":"2.0","id":3,"result":null})");
}

TEST_F(MessageHandlerTest, AFaultInWhatAReplyCausesIsALogLine) {
  session_.outbox().request("test/ask", [](const nlohmann::json&) { throw InternalError("a third invariant"); });
  ASSERT_EQ(replies_.size(), 1u);
  send(R"({"jsonrpc":"2.0","id":1,"result":null})");
  EXPECT_EQ(log_lines_, "error   internal error in the reply 1: a third invariant\n");
  send(R"({"jsonrpc":"2.0","id":3,"method":"shutdown"})");
  EXPECT_EQ(replies_.back(), R"({"jsonrpc":"2.0","id":3,"result":null})");
}

TEST_F(MessageHandlerTest, AfterAFaultAllIsFormedAnewFromTheTexts) {
  open("a");
  edit("a");
  send(R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/stats"})");
  EXPECT_TRUE(last_reply_has(R"("blocksParsed":1,"definitionsChecked":1)")) << replies_.back();
  edit("a");
  send(R"({"jsonrpc":"2.0","id":2,"method":"test/brokenInvariant"})");
  EXPECT_TRUE(last_reply_has(R"("id":2,"error":{"code":-32603)")) << replies_.back();
  send(R"({"jsonrpc":"2.0","id":3,"method":"texbrdf/stats"})");
  EXPECT_TRUE(last_reply_has(R"("blocksParsed":2,"definitionsChecked":2)")) << replies_.back();
  send(R"({"jsonrpc":"2.0","id":4,"method":"textDocument/hover","params":{"textDocument":{"uri":"a"},)"
       R"("position":{"line":0,"character":20}}})");
  EXPECT_TRUE(last_reply_has("a = 233")) << replies_.back();
}

TEST_F(MessageHandlerTest, WhatWasPublishedBeforeAFaultIsPublishedAgain) {
  open("a");
  replies_.clear();
  send(R"({"jsonrpc":"2.0","id":1,"method":"test/brokenInvariant"})");
  publish();
  ASSERT_EQ(replies_.size(), 2u);
  EXPECT_TRUE(last_reply_has("publishDiagnostics")) << replies_.back();
}

TEST_F(MessageHandlerTest, AFaultInAPublicationIsTriedAgainOnce) {
  unsendable_ = R"("uri":"b")";
  open("a");
  EXPECT_TRUE(last_reply_has(R"("uri":"a")"));
  open("b");
  EXPECT_EQ(log_lines_,
            "error   internal error in diagnostics: unsendable\n"
            "error   internal error in diagnostics: unsendable\n");
  log_lines_.clear();
  open("c");
  EXPECT_TRUE(last_reply_has(R"("uri":"c")")) << replies_.back();
  EXPECT_EQ(log_lines_, "");
  unsendable_.clear();
  edit("b");
  publish();
  EXPECT_TRUE(last_reply_has(R"("uri":"b")")) << replies_.back();
}

TEST_F(MessageHandlerTest, FaultsThatDoNotEndAreNotTriedForEver) {
  for (int i = 0; i < 100; ++i) handler_.publish_next();
  EXPECT_FALSE(handler_.has_publications());
  open("a");
  EXPECT_TRUE(last_reply_has("publishDiagnostics")) << replies_.back();
}

/// The handler of a method that is switched off is not even called.
TEST_F(MessageHandlerTest, AFeatureThatIsSwitchedOffIsAnsweredWithNull) {
  const char* hover = R"({"jsonrpc":"2.0","id":1,"method":"textDocument/hover","params":{}})";
  send(
      R"({"jsonrpc":"2.0","method":"workspace/didChangeConfiguration","params":{"settings":{"features.hover":false}}})");
  send(hover);
  EXPECT_EQ(replies_.back(), R"({"jsonrpc":"2.0","id":1,"result":null})");
  send(R"({"jsonrpc":"2.0","method":"workspace/didChangeConfiguration","params":{"settings":null}})");
  send(hover);
  EXPECT_NE(replies_.back().find("-32602"), std::string::npos) << replies_.back();
}

TEST_F(MessageHandlerTest, AMethodIsBoundOnce) {
  EXPECT_THROW(methods_.request("shutdown", faulty_, &Faulty::out_of_memory), InternalError);
}

}  // namespace
}  // namespace texbrdf::lsp

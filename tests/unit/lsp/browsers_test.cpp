#include "lsp/browsers.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lsp/framing.h"
#include "lsp/json_rpc.h"
#include "lsp/message_handler.h"
#include "lsp/message_queue.h"
#include "lsp/previews.h"
#include "support/memory_channel.h"

namespace texbrdf::lsp {
namespace {

using Told = std::vector<std::pair<ViewerId, std::string>>;

TEST(Browsers, AreToldOfTheDocumentWhenItIsAnotherOrHasChanged) {
  Told told;
  Browsers browsers;
  EXPECT_FALSE(browsers.are_served());
  browsers.connect("http://127.0.0.1:1/secret/",
                   [&](ViewerId browser, std::string body) { told.emplace_back(browser, std::move(body)); });
  browsers.add(1);
  browsers.follow(FollowedDocument{"file:///a/my%20paper.tex", 3});
  browsers.follow(FollowedDocument{"file:///a/my%20paper.tex", 3});
  browsers.add(2);
  browsers.remove(1);
  browsers.follow(FollowedDocument{"file:///a/my%20paper.tex", 4});
  browsers.follow(std::nullopt);
  const std::string document = R"({"jsonrpc":"2.0","method":"texbrdf/document","params":)";
  const std::string third = document + R"({"uri":"file:///a/my%20paper.tex","name":"my paper.tex","version":3}})";
  const std::string fourth = document + R"({"uri":"file:///a/my%20paper.tex","name":"my paper.tex","version":4}})";
  const std::string none = document + R"({"uri":null}})";
  const Told expected = {{1, R"({"jsonrpc":"2.0","method":"texbrdf/welcome","params":{"client":1}})"},
                         {1, none},
                         {1, third},
                         {2, R"({"jsonrpc":"2.0","method":"texbrdf/welcome","params":{"client":2}})"},
                         {2, third},
                         {2, fourth},
                         {2, none}};
  EXPECT_EQ(told, expected);
}

TEST(Browsers, MayAskForPicturesAndForNothingElse) {
  for (const char* method : {"texbrdf/openPreview", "texbrdf/frameShown", "texbrdf/probe", "texbrdf/applyEdit"}) {
    EXPECT_TRUE(is_for_browsers(method)) << method;
  }
  for (const char* method : {"", "initialize", "shutdown", "exit", "textDocument/didChange", "textDocument/hover",
                             "workspace/executeCommand", "texbrdf/stats", "texbrdf", "$/cancelRequest"}) {
    EXPECT_FALSE(is_for_browsers(method)) << method;
  }
}

TEST(PreviewsOfViewers, EachHasItsOwn) {
  Previews previews;
  previews.serve(1);
  const int64_t first = previews.open({.viewer = kEditor, .uri = "a", .root = {}, .view = {}, .values = {}});
  previews.serve(2);
  const int64_t second = previews.open({.viewer = kEditor, .uri = "a", .root = {}, .view = {}, .values = {}});
  EXPECT_EQ(previews.find(first), nullptr);
  previews.close(first);
  previews.serve(1);
  ASSERT_NE(previews.find(first), nullptr) << "only its own viewer closes it";
  EXPECT_EQ(previews.find(first)->viewer, 1U);
  EXPECT_EQ(previews.find(second), nullptr);
  EXPECT_NE(previews.find_of_any(second), nullptr);
  previews.close_all_of(2);
  EXPECT_EQ(previews.find_of_any(second), nullptr);
  EXPECT_NE(previews.find(first), nullptr);
}

TEST(PreviewsOfViewers, AreNotOpenedWithoutEnd) {
  Previews previews;
  for (int i = 0; i < 256; ++i) {
    EXPECT_FALSE(previews.are_many());
    previews.open({.viewer = kEditor, .uri = "a", .root = {}, .view = {}, .values = {}});
  }
  EXPECT_TRUE(previews.are_many());
}

TEST(QueueOfViewers, AnEditorCancelsNoRequestOfABrowser) {
  Log log(LogLevel::Error, [](std::string_view) {});
  test::MemoryChannel channel;
  channel.add(frame(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":5}})"));
  MessageQueue queue(channel, log);
  queue.add_from(7, R"({"jsonrpc":"2.0","id":5,"method":"texbrdf/roots","params":{}})");
  queue.receive(1);
  const MessageQueue::Entry entry = queue.pop();
  EXPECT_EQ(entry.sender, 7U);
  EXPECT_FALSE(entry.cancelled);
}

class BrowserMessagesTest : public testing::Test {
 protected:
  BrowserMessagesTest() {
    session_.bind_methods(methods_);
    session_.browsers().connect("http://127.0.0.1:1/secret/", [this](ViewerId browser, std::string body) {
      told_.emplace_back(browser, std::move(body));
    });
    say(kEditor, R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"capabilities":{}}})");
    session_.browser_came(7);
    told_.clear();
    editors_.clear();
  }
  void say(ViewerId sender, const std::string& body) {
    handler_.handle({.message = parse_message(body), .sender = sender});
  }

  Told told_;
  std::vector<std::string> editors_;
  Log log_{LogLevel::Error, [](std::string_view) {}};
  ClientProcess client_process_{process_exists};
  Session session_{log_, client_process_, "", ""};
  Dispatcher methods_;
  MessageHandler handler_{session_, methods_, log_, [this](std::string body) { editors_.push_back(std::move(body)); }};
};

TEST_F(BrowserMessagesTest, TheAnswerGoesToWhoAsked) {
  say(7, R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/roots","params":{"uri":"file:///a.tex"}})");
  say(7, R"({"jsonrpc":"2.0","id":2,"method":"shutdown"})");
  say(kEditor, R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/stats"})");
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_EQ(told_[0].first, 7U);
  EXPECT_NE(told_[0].second.find(R"("id":1,"error":{"code":-32602)"), std::string::npos) << told_[0].second;
  EXPECT_NE(told_[1].second.find(R"("id":2,"error":{"code":-32601)"), std::string::npos) << told_[1].second;
  ASSERT_EQ(editors_.size(), 1U);
  EXPECT_NE(editors_[0].find(R"("id":1,"result")"), std::string::npos) << editors_[0];
}

TEST_F(BrowserMessagesTest, WhoIsGoneIsNotListenedTo) {
  session_.browser_went(7);
  say(7, R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/roots","params":{"uri":"file:///a.tex"}})");
  EXPECT_TRUE(told_.empty());
}

TEST_F(BrowserMessagesTest, ABrowserEndsNothing) {
  say(7, R"({"jsonrpc":"2.0","method":"exit"})");
  EXPECT_EQ(session_.phase(), Session::Phase::Running);
}

TEST_F(BrowserMessagesTest, NoProgressOfABrowsersRequestReachesTheEditor) {
  say(7, R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/roots","params":{"uri":"a","workDoneToken":"x"}})");
  EXPECT_TRUE(editors_.empty());
}

TEST_F(BrowserMessagesTest, AnEditorThatTakesNoEditsIsNotAsked) {
  say(7, R"({"jsonrpc":"2.0","id":1,"method":"texbrdf/applyEdit","params":{"changes":[]}})");
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_NE(told_[0].second.find("the editor takes no edits"), std::string::npos) << told_[0].second;
  EXPECT_TRUE(editors_.empty());
}

}  // namespace
}  // namespace texbrdf::lsp

#include "lsp/outbox.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace texbrdf::lsp {
namespace {

class OutboxTest : public testing::Test {
 protected:
  OutboxTest() {
    outbox_.connect([this](const std::string& body) { sent_.push_back(body); });
  }
  void reply(const char* body) { outbox_.take_reply(parse_message(body)); }
  void ask() {
    outbox_.request("test/ask", [this](const nlohmann::json& result) { results_.push_back(result.dump()); });
  }

  std::string log_lines_;
  Log log_{LogLevel::Debug, [this](std::string_view line) { log_lines_ += line.substr(line.find(']') + 2); }};
  Outbox outbox_{log_};
  std::vector<std::string> sent_;
  std::vector<std::string> results_;
};

TEST_F(OutboxTest, RepliesAreMatchedByTheirIds) {
  outbox_.request("test/first", [](JsonWriter& params) { params.value("x"); });
  ask();
  ask();
  EXPECT_EQ(sent_, (std::vector<std::string>{R"({"jsonrpc":"2.0","id":1,"method":"test/first","params":"x"})",
                                             R"({"jsonrpc":"2.0","id":2,"method":"test/ask"})",
                                             R"({"jsonrpc":"2.0","id":3,"method":"test/ask"})"}));
  reply(R"({"jsonrpc":"2.0","id":3,"result":"third"})");
  reply(R"({"jsonrpc":"2.0","id":2,"result":null})");
  reply(R"({"jsonrpc":"2.0","id":1,"result":[]})");
  EXPECT_EQ(results_, (std::vector<std::string>{"\"third\"", "null"}));
  EXPECT_EQ(log_lines_, "");
}

TEST_F(OutboxTest, WhatNobodyWaitsForIsIgnored) {
  ask();
  for (const char* id : {"2", "\"1\"", "-1", "null", "99999999999999999999", "1.5"}) {
    reply((std::string(R"({"jsonrpc":"2.0","result":1,"id":)") + id + "}").c_str());
  }
  EXPECT_TRUE(results_.empty());
  reply(R"({"jsonrpc":"2.0","id":1,"result":1})");
  reply(R"({"jsonrpc":"2.0","id":1,"result":2})");
  EXPECT_EQ(results_, std::vector<std::string>{"1"});
}

TEST_F(OutboxTest, ARefusalIsALogLineAndNull) {
  ask();
  ask();
  reply(R"({"jsonrpc":"2.0","id":1,"error":{"code":-32601,"message":"unknown"}})");
  reply(R"({"jsonrpc":"2.0","id":2,"error":"no"})");
  EXPECT_EQ(results_, (std::vector<std::string>{"null", "null"}));
  EXPECT_EQ(log_lines_,
            "warning the client refused test/ask: unknown\n"
            "warning the client refused test/ask: without a reason\n");
}

TEST_F(OutboxTest, AClientThatNeverRepliesFillsNoMemory) {
  for (int i = 0; i < 1001; ++i) ask();
  reply(R"({"jsonrpc":"2.0","id":1,"result":1})");
  reply(R"({"jsonrpc":"2.0","id":2,"result":2})");
  EXPECT_EQ(results_, std::vector<std::string>{"2"});
}

}  // namespace
}  // namespace texbrdf::lsp

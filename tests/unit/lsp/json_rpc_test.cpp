#include "lsp/json_rpc.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "lsp/json_limits.h"

namespace texbrdf::lsp {
namespace {

using Kind = IncomingMessage::Kind;

TEST(JsonRpc, RequestNotificationResponse) {
  const auto request = parse_message(R"({"jsonrpc":"2.0","id":7,"method":"m","params":{"a":1}})");
  EXPECT_EQ(request.kind, Kind::Request);
  EXPECT_EQ(request.id, "7");
  EXPECT_EQ(request.method, "m");
  EXPECT_EQ(request.params->dump(), R"({"a":1})");

  const auto notification = parse_message(R"({"jsonrpc":"2.0","method":"n"})");
  EXPECT_EQ(notification.kind, Kind::Notification);
  EXPECT_EQ(notification.id, "");
  EXPECT_TRUE(notification.params->is_null());

  EXPECT_EQ(parse_message(R"({"jsonrpc":"2.0","id":1,"result":null})").kind, Kind::Response);
  EXPECT_EQ(parse_message(R"({"jsonrpc":"2.0","id":null,"error":{"code":-1,"message":"x"}})").kind, Kind::Response);
}

TEST(JsonRpc, IdsAreStringsIntegersOrNull) {
  const auto id_of = [](const std::string& id) {
    return parse_message(R"({"jsonrpc":"2.0","method":"m","id":)" + id + "}").id;
  };
  EXPECT_EQ(id_of("\"a\\u0022b\""), "\"a\\\"b\"");
  EXPECT_EQ(id_of("-3"), "-3");
  EXPECT_EQ(id_of("18446744073709551615"), "18446744073709551615");
  EXPECT_EQ(id_of("null"), "null");
}

struct BrokenCase {
  const char* body;
  ErrorCode code;
  const char* id;
};

TEST(JsonRpc, BrokenMessagesSayWhatTheSpecificationAsks) {
  const BrokenCase cases[] = {
      {"", ErrorCode::ParseError, "null"},
      {"{bad json", ErrorCode::ParseError, "null"},
      {"{}{}", ErrorCode::ParseError, "null"},
      {"{\"a\":\"\xff\"}", ErrorCode::ParseError, "null"},
      {"1", ErrorCode::InvalidRequest, "null"},
      {"null", ErrorCode::InvalidRequest, "null"},
      {"[]", ErrorCode::InvalidRequest, "null"},
      {R"([{"jsonrpc":"2.0","id":1,"method":"m"}])", ErrorCode::InvalidRequest, "null"},
      {"{}", ErrorCode::InvalidRequest, "null"},
      {R"({"id":4,"method":"m"})", ErrorCode::InvalidRequest, "4"},
      {R"({"jsonrpc":"1.0","id":4,"method":"m"})", ErrorCode::InvalidRequest, "4"},
      {R"({"jsonrpc":2.0,"id":4,"method":"m"})", ErrorCode::InvalidRequest, "4"},
      {R"({"jsonrpc":"2.0","id":4})", ErrorCode::InvalidRequest, "4"},
      {R"({"jsonrpc":"2.0","id":4,"method":5})", ErrorCode::InvalidRequest, "4"},
      {R"({"jsonrpc":"2.0","id":"x","method":"m","params":5})", ErrorCode::InvalidRequest, "\"x\""},
      {R"({"jsonrpc":"2.0","method":1,"params":"bar"})", ErrorCode::InvalidRequest, "null"},
      {R"({"jsonrpc":"2.0","id":1.5,"method":"m"})", ErrorCode::InvalidRequest, "null"},
      {R"({"jsonrpc":"2.0","id":{},"method":"m"})", ErrorCode::InvalidRequest, "null"},
      {R"({"jsonrpc":"2.0","id":true,"method":"m"})", ErrorCode::InvalidRequest, "null"},
  };
  for (const BrokenCase& test : cases) {
    const auto message = parse_message(test.body);
    EXPECT_EQ(message.kind, Kind::Broken) << test.body;
    EXPECT_EQ(message.problem.code, test.code) << test.body;
    EXPECT_EQ(message.id, test.id) << test.body;
  }
}

TEST(JsonRpc, ALoneSurrogateIsReadAsReplacementCharacter) {
  const auto message =
      parse_message(R"({"jsonrpc":"2.0","method":"m","params":{"text":"\ud83d\ude00 \ud83d! \ude00 \\ud83d"}})");
  ASSERT_EQ(message.kind, Kind::Notification);
  EXPECT_EQ((*message.params)["text"].get<std::string>(), "😀 \uFFFD! \uFFFD \\ud83d");
}

TEST(JsonRpc, DeepOrManyValuesAreRefusedBeforeTheyAreStored) {
  EXPECT_EQ(parse_message(std::string(kMaxJsonDepth + 1, '[')).problem.code, ErrorCode::InvalidRequest);
  EXPECT_EQ(parse_message(std::string(kMaxJsonDepth, '[')).problem.code, ErrorCode::ParseError);
  std::string many = "[0";
  for (uint32_t i = 0; i < kMaxJsonValues; ++i) many += ",0";
  EXPECT_EQ(parse_message(many + "]").problem.code, ErrorCode::InvalidRequest);
  EXPECT_FALSE(exceeds_json_limits("\"" + std::string(10000, '[') + "\\\"" + std::string(10000, '[')));
}

TEST(JsonRpc, RepliesAreJson) {
  JsonWriter response;
  begin_response(response, "\"a\"");
  response.value(1);
  response.end_object();
  EXPECT_EQ(response.text(), R"({"jsonrpc":"2.0","id":"a","result":1})");
  JsonWriter notification;
  begin_notification(notification, "m");
  notification.null();
  notification.end_object();
  EXPECT_EQ(notification.text(), R"({"jsonrpc":"2.0","method":"m","params":null})");
  EXPECT_EQ(error_text("null", {ErrorCode::ParseError, "a \"b\""}),
            R"({"jsonrpc":"2.0","id":null,"error":{"code":-32700,"message":"a \"b\""}})");
}

}  // namespace
}  // namespace texbrdf::lsp

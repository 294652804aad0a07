#include "lsp/read_params.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace texbrdf::lsp {
namespace {

template <typename Params>
std::string problem_of(const char* text) {
  auto json = nlohmann::json::parse(text);
  Params params;
  return read_params(json, params);
}

TEST(ReadParams, Position) {
  auto json = nlohmann::json::parse(R"({"textDocument":{"uri":"u"},"position":{"line":3,"character":4.0},"more":[]})");
  PositionParams params;
  EXPECT_EQ(read_params(json, params), "");
  EXPECT_EQ(params.uri, "u");
  EXPECT_EQ(params.position, (Position{3, 4}));
}

TEST(ReadParams, TheFirstProblemIsTold) {
  EXPECT_EQ(problem_of<PositionParams>("null"), "`params` has to be an object");
  EXPECT_EQ(problem_of<PositionParams>("[]"), "`params` has to be an object");
  EXPECT_EQ(problem_of<PositionParams>("{}"), "`textDocument` has to be an object");
  EXPECT_EQ(problem_of<PositionParams>(R"({"textDocument":{}})"), "`uri` has to be a string");
  EXPECT_EQ(problem_of<PositionParams>(R"({"textDocument":{"uri":"u"}})"), "`position` has to be an object");
  EXPECT_EQ(problem_of<PositionParams>(R"({"textDocument":{"uri":"u"},"position":{"line":-1,"character":0}})"),
            "`line` has to be a natural number");
  EXPECT_EQ(problem_of<PositionParams>(R"({"textDocument":{"uri":"u"},"position":{"line":0,"character":0.5}})"),
            "`character` has to be a natural number");
  EXPECT_EQ(problem_of<ReferenceParams>(R"({"textDocument":{"uri":"u"},"position":{"line":0,"character":0}})"),
            "`context` has to be an object");
  EXPECT_EQ(problem_of<DidOpenParams>(R"({"textDocument":{"uri":"u","version":1}})"), "`text` has to be a string");
  EXPECT_EQ(problem_of<DidChangeParams>(R"({"textDocument":{"uri":"u"},"contentChanges":[1]})"),
            "`contentChanges` has to be an array of objects");
  EXPECT_EQ(problem_of<DidChangeParams>(R"({"textDocument":{"uri":"u"},"contentChanges":[{"range":{}}]})"),
            "`start` has to be an object");
}

TEST(ReadParams, HugeNumbersAreTheLargest) {
  auto json = nlohmann::json::parse(
      R"({"textDocument":{"uri":"u"},"position":{"line":18446744073709551615,"character":4294967296}})");
  PositionParams params;
  EXPECT_EQ(read_params(json, params), "");
  EXPECT_EQ(params.position, (Position{INT32_MAX, INT32_MAX}));
}

TEST(ReadParams, OddCapabilitiesAreNoReasonToRefuseAClient) {
  auto json = nlohmann::json::parse(
      R"({"processId":null,"clientInfo":3,"capabilities":{"general":{"positionEncodings":[1,"utf-8"]},"textDocument":{
          "definition":{"linkSupport":"yes"},"publishDiagnostics":{"relatedInformation":true}}}})");
  InitializeParams params;
  EXPECT_EQ(read_params(json, params), "");
  EXPECT_FALSE(params.process_id);
  EXPECT_EQ(params.position_encodings, std::vector<std::string>{"utf-8"});
  EXPECT_FALSE(params.definition_links);
  EXPECT_TRUE(params.related_information);
}

}  // namespace
}  // namespace texbrdf::lsp

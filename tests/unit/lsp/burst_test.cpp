#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lsp/framing.h"
#include "lsp/server.h"
#include "support/memory_channel.h"
#include "support/random.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

constexpr int kEdits = 500;

std::string message(const json& body) {
  return frame(body.dump());
}

std::string initialize() {
  return message(
      {{"jsonrpc", "2.0"}, {"id", 0}, {"method", "initialize"}, {"params", {{"capabilities", json::object()}}}});
}

std::string open(const std::string& text) {
  const json document = {{"uri", "u"}, {"languageId", "latex"}, {"version", 0}, {"text", text}};
  return message({{"jsonrpc", "2.0"}, {"method", "textDocument/didOpen"}, {"params", {{"textDocument", document}}}});
}

/// Puts the text in front of the document's first line.
std::string insertion(int version, const std::string& text) {
  const json start = {{"line", 0}, {"character", 0}};
  const json change = {{"range", {{"start", start}, {"end", start}}}, {"text", text}};
  const json document = {{"uri", "u"}, {"version", version}};
  return message({{"jsonrpc", "2.0"},
                  {"method", "textDocument/didChange"},
                  {"params", {{"textDocument", document}, {"contentChanges", json::array({change})}}}});
}

/// Equations with and without faults, among them the root and a second definition of it.
std::string random_equation(test::Random& random) {
  static const std::vector<std::string> contents = {"f = a + 1", "a = 2", "b = a*(", "c = zz", "a = b", "% f = 2"};
  const std::string& content = random.one_of(contents);
  return "\\begin{equation}\n" + content + "\n\\end{equation}\n";
}

struct Published {
  int64_t version = 0;
  json diagnostics;
};

std::vector<Published> serve(const std::vector<std::string>& chunks) {
  test::MemoryChannel channel;
  for (const std::string& chunk : chunks) channel.add(chunk);
  Log log(LogLevel::Error, [](std::string_view line) { ADD_FAILURE() << line; });
  run_server(channel, log, {.process_alive = [](int64_t) { return true; }});
  std::vector<Published> published;
  for (const std::string& reply : channel.replies()) {
    FrameDecoder decoder;
    decoder.input() = reply;
    while (auto next = decoder.next()) {
      const json body = json::parse(std::get<Frame>(*next).body);
      if (!body.contains("method")) continue;
      published.push_back({body["params"]["version"].get<int64_t>(), body["params"]["diagnostics"]});
    }
  }
  return published;
}

class Burst : public testing::TestWithParam<int> {};

/// Edits that nobody waits for, arriving in pieces of up to so many: each publish is newer than the one before and as
/// if its version were all that the document ever was, and the last is of the last version.
TEST_P(Burst, EveryPublishIsRightForItsVersion) {
  test::Random random(static_cast<uint64_t>(GetParam()));
  std::vector<std::string> texts = {""};
  std::vector<std::string> chunks = {initialize() + open("")};
  for (int version = 1; version <= kEdits;) {
    std::string chunk;
    for (int more = random.between(1, GetParam()); more > 0 && version <= kEdits; --more) {
      const std::string inserted = random_equation(random);
      texts.push_back(inserted + texts.back());
      chunk += insertion(version++, inserted);
    }
    chunks.push_back(chunk);
  }
  const std::vector<Published> published = serve(chunks);
  ASSERT_FALSE(published.empty());
  EXPECT_LE(published.size(), chunks.size());
  EXPECT_EQ(published.back().version, kEdits);
  int64_t last = -1;
  for (std::size_t i = 0; i < published.size(); ++i) {
    EXPECT_GT(published[i].version, last);
    last = published[i].version;
    if (i % 7 != 0 && i + 1 != published.size()) continue;
    const auto fresh = serve({initialize() + open(texts[static_cast<std::size_t>(last)])});
    ASSERT_EQ(fresh.size(), 1u);
    EXPECT_EQ(published[i].diagnostics, fresh[0].diagnostics) << "version " << last;
  }
}

INSTANTIATE_TEST_SUITE_P(PiecesOfUpTo, Burst, testing::Values(20, 100, kEdits));

}  // namespace
}  // namespace texbrdf::lsp

#include <gtest/gtest.h>

#include <string>

#include "lsp/framing.h"
#include "lsp/log.h"
#include "lsp/server.h"
#include "support/memory_channel.h"

namespace texbrdf::lsp {
namespace {

/// The answer to a hover over the root of a document.
std::string hover(const std::string& capabilities, const std::string& options, const std::string& equation) {
  test::MemoryChannel channel;
  const auto send = [&](const std::string& content) { channel.add(frame(R"({"jsonrpc":"2.0",)" + content + "}")); };
  send(R"("id":0,"method":"initialize","params":{"processId":null,"capabilities":)" + capabilities +
       R"(,"initializationOptions":)" + options + "}");
  send(R"("method":"textDocument/didOpen","params":{"textDocument":{"uri":"a","languageId":"latex","version":1,)"
       R"("text":"\\begin{equation})" +
       equation + R"(\\end{equation}"}})");
  send(R"("id":1,"method":"textDocument/hover","params":{"textDocument":{"uri":"a"},)"
       R"("position":{"line":0,"character":16}})");
  Log log(LogLevel::Error, [](std::string_view) {});
  run_server(channel, log, {});
  std::string all;
  for (const std::string& reply : channel.replies()) all += reply;
  const std::size_t begin = all.find(R"("id":1,)");
  return begin == std::string::npos ? all : all.substr(begin);
}

constexpr const char* kWithParser = R"({"general":{"markdown":{"parser":"marked"}}})";
constexpr const char* kWithout = R"({"textDocument":{"hover":{"contentFormat":["markdown","plaintext"]}}})";
constexpr const char* kPlain =
    R"({"general":{"markdown":{"parser":"marked"}},"textDocument":{"hover":{"contentFormat":["plaintext"]}}})";
constexpr const char* kRoot = R"(f = \\cos{\\theta_i})";
constexpr const char* kPicture = "![over the sphere](data:image/png;base64,iVBOR";
constexpr const char* kRange = ", sampled over the hemisphere";

bool has(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

TEST(HoverPicture, GoesToClientsThatNameTheParserOfTheirMarkdown) {
  const std::string answer = hover(kWithParser, "{}", kRoot);
  EXPECT_TRUE(has(answer, kPicture)) << answer;
  EXPECT_TRUE(has(answer, kRange)) << answer;
  for (const char* capabilities : {kWithout, kPlain}) {
    const std::string without = hover(capabilities, "{}", kRoot);
    EXPECT_TRUE(has(without, "defined on line 1")) << without;
    EXPECT_FALSE(has(without, kPicture)) << without;
    EXPECT_FALSE(has(without, kRange)) << without;
  }
}

TEST(HoverPicture, IsSwitchedOnAndOff) {
  EXPECT_TRUE(has(hover(kWithout, R"({"hover.picture":"on"})", kRoot), kPicture));
  EXPECT_FALSE(has(hover(kWithParser, R"({"hover.picture":"off"})", kRoot), kPicture));
  const std::string plain = hover(kPlain, R"({"hover.picture":"on"})", kRoot);
  EXPECT_FALSE(has(plain, kPicture));
  EXPECT_TRUE(has(plain, kRange));
}

TEST(HoverPicture, IsLeftOutOfWhatIsConstantOrTooLong) {
  EXPECT_FALSE(has(hover(kWithParser, "{}", "f = 2 * 3"), kPicture));
  std::string sum = kRoot;
  for (int i = 0; i < 400; ++i) sum += R"( + \\theta_h)";
  EXPECT_TRUE(has(hover(kWithParser, "{}", sum), kPicture));
  for (int i = 0; i < 600; ++i) sum += R"( + \\theta_h)";
  EXPECT_FALSE(has(hover(kWithParser, "{}", sum), kPicture));
}

}  // namespace
}  // namespace texbrdf::lsp

#include "lsp/server.h"

#include <gtest/gtest.h>

#include <string>

#include "lsp/framing.h"
#include "support/memory_channel.h"

namespace texbrdf::lsp {
namespace {

constexpr const char* kInitialize =
    R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"processId":77,"capabilities":{}}})";

struct Session {
  int status = 0;
  std::string log;
  std::vector<std::string> replies;
};

Session served(test::MemoryChannel& channel, ServerOptions options) {
  Session result;
  Log log(LogLevel::Debug, [&](std::string_view line) { result.log += line; });
  result.status = run_server(channel, log, options);
  result.replies = channel.replies();
  return result;
}

/// Counts down with each question.
std::function<bool(int64_t)> alive_for(int& questions) {
  return [&questions](int64_t process) { return process == 77 && questions-- > 0; };
}

TEST(Server, EndsWhenTheClientProcessIsGone) {
  int questions = 3;
  test::MemoryChannel channel;
  channel.add(frame(kInitialize));
  for (int i = 0; i < 10; ++i) channel.add("");
  const Session result = served(channel, {.process_alive = alive_for(questions)});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.replies.size(), 4u);
  EXPECT_NE(result.log.find("the client's process is gone"), std::string::npos);
}

TEST(Server, AProcessThatWasNeverSeenIsNotWatched) {
  int questions = 0;
  test::MemoryChannel channel;
  channel.add(frame(kInitialize));
  for (int i = 0; i < 10; ++i) channel.add("");
  const Session result = served(channel, {.process_alive = alive_for(questions)});
  EXPECT_EQ(result.replies.size(), 12u);
  EXPECT_NE(result.log.find("client process 77 cannot be watched"), std::string::npos);
}

TEST(Server, TheLogSaysWhatABugReportNeeds) {
  test::MemoryChannel channel;
  channel.add(frame(kInitialize));
  channel.add(frame("{") + "Content-Length: 100\r\n\r\n{");
  const Session result = served(channel, {.version = "1.2.3", .process_alive = [](int64_t) { return true; }});
  for (const char* part : {"texbrdf 1.2.3, process ", "positions in utf-16", "initialize 0: ", " ms",
                           "broken message: the message is not JSON", "the input ends inside a message",
                           "the client closed the connection, status 1"}) {
    EXPECT_NE(result.log.find(part), std::string::npos) << part << " in\n" << result.log;
  }
}

std::size_t publications(const Session& session) {
  std::size_t count = 0;
  for (const std::string& reply : session.replies) {
    for (std::size_t at = reply.find("publishDiagnostics"); at != std::string::npos;
         at = reply.find("publishDiagnostics", at + 1)) {
      ++count;
    }
  }
  return count;
}

/// An opened document and edits of it, one behind the other in one chunk.
std::string burst(int edits) {
  std::string bytes = frame(kInitialize);
  bytes += frame(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":)"
                 R"({"uri":"u","languageId":"latex","version":0,"text":""}}})");
  for (int version = 1; version <= edits; ++version) {
    bytes +=
        frame(R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":"u","version":)" +
              std::to_string(version) + R"(},"contentChanges":[{"text":"x"}]}})");
  }
  return bytes;
}

TEST(Server, ABurstOfEditsEndsInOnePublication) {
  test::MemoryChannel channel;
  channel.add(burst(500));
  const Session session = served(channel, {.process_alive = [](int64_t) { return true; }});
  EXPECT_EQ(publications(session), 1u);
  EXPECT_NE(session.replies[0].find("\"version\":500"), std::string::npos);
}

TEST(Server, AClientThatNeverPausesGetsDiagnosticsFromTimeToTime) {
  test::MemoryChannel channel;
  channel.add(burst(3500));
  const Session session = served(channel, {.process_alive = [](int64_t) { return true; }});
  EXPECT_EQ(publications(session), 4u);
  EXPECT_NE(session.replies[0].find("\"version\":3500"), std::string::npos);
}

std::string opened(const std::string& text) {
  return frame(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":)"
               R"({"uri":"file:///a.tex","languageId":"latex","version":0,"text":")" +
               text + R"("}}})");
}

TEST(Server, TheFirstAnalysisOfALargeDocumentShowsItsProgress) {
  constexpr const char* kClient = R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":)"
                                  R"({"capabilities":{"window":{"workDoneProgress":true}}}})";
  const std::string equation = "\\\\begin{equation} f = 1 \\\\end{equation} ";
  test::MemoryChannel channel;
  channel.add(frame(kClient));
  channel.add(opened(equation));
  channel.add(opened(equation + std::string(std::size_t{1} << 20, 'x')));
  channel.add(frame(R"({"jsonrpc":"2.0","id":1,"result":null})"));
  const Session session = served(channel, {.process_alive = [](int64_t) { return true; }});
  EXPECT_EQ(session.replies[1].find("rogress"), std::string::npos) << "small";
  std::size_t at = 0;
  for (const char* part : {R"("id":1,"method":"window/workDoneProgress/create","params":{"token":"texbrdf/1"})",
                           R"("kind":"begin","title":"analysing /a.tex")", R"("kind":"end")", "publishDiagnostics"}) {
    at = session.replies[2].find(part, at);
    EXPECT_NE(at, std::string::npos) << part;
  }
}

TEST(Server, AnUnwritableLogFileIsBadUsage) {
  EXPECT_EQ(run_server({.log_file = "/nowhere/at/all"}), 2);
}

}  // namespace
}  // namespace texbrdf::lsp

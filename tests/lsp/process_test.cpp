#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lsp/framing.h"

namespace texbrdf::test {
namespace {

/// Long enough for a loaded machine with sanitizers; reached only where something is wrong.
constexpr int kDeadlineMs = 30000;

/// `texbrdf lsp` as a child process, from a client's side.
class Daemon {
 public:
  Daemon() {
    std::array<int, 2> to_daemon{};
    std::array<int, 2> from_daemon{};
    if (pipe2(to_daemon.data(), O_CLOEXEC) != 0 || pipe2(from_daemon.data(), O_CLOEXEC) != 0) {
      throw std::runtime_error("no pipes");
    }
    signal(SIGPIPE, SIG_IGN);
    process_ = fork();
    if (process_ == 0) {
      dup2(to_daemon[0], STDIN_FILENO);
      dup2(from_daemon[1], STDOUT_FILENO);
      const int nothing = open("/dev/null", O_WRONLY);
      dup2(nothing, STDERR_FILENO);
      execl(TEXBRDF_PROGRAM, TEXBRDF_PROGRAM, "lsp", "--stdio", nullptr);
      _exit(127);
    }
    close(to_daemon[0]);
    close(from_daemon[1]);
    input_ = to_daemon[1];
    output_ = from_daemon[0];
  }
  ~Daemon() {
    close_input();
    close_output();
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  void send_bytes(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = write(input_, bytes.data(), bytes.size());
      if (count <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void send(std::string_view body) const { send_bytes(lsp::frame(std::string(body))); }

  /// The next message; empty where the output ends or the deadline passes. Anything else on the output is a failure.
  std::string receive() {
    for (;;) {
      if (auto next = decoder_.next()) {
        if (const auto* problem = std::get_if<lsp::FramingProblem>(&*next)) {
          ADD_FAILURE() << problem->message;
          return {};
        }
        return std::string(std::get<lsp::Frame>(*next).body);
      }
      pollfd ready = {output_, POLLIN, 0};
      std::array<char, 4096> chunk;
      if (poll(&ready, 1, kDeadlineMs) <= 0) return {};
      const ssize_t count = read(output_, chunk.data(), chunk.size());
      if (count <= 0) return {};
      decoder_.input().append(chunk.data(), static_cast<std::size_t>(count));
    }
  }

  void close_input() {
    if (input_ >= 0) close(input_);
    input_ = -1;
  }
  void close_output() {
    if (output_ >= 0) close(output_);
    output_ = -1;
  }

  /// -1 where it did not end by itself in time.
  int exit_status() {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(kDeadlineMs);
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > deadline) return -1;
      usleep(2000);
    }
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  lsp::FrameDecoder decoder_;
};

std::string initialize(pid_t client) {
  return R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{"processId":)" + std::to_string(client) +
         R"(,"capabilities":{}}})";
}

constexpr const char* kShutdown = R"({"jsonrpc":"2.0","id":"s","method":"shutdown"})";
constexpr const char* kExit = R"({"jsonrpc":"2.0","method":"exit"})";

TEST(LspProcess, ShutdownAndExitEndWithStatus0) {
  Daemon daemon;
  daemon.send(initialize(getpid()));
  EXPECT_NE(daemon.receive().find("\"capabilities\""), std::string::npos);
  daemon.send(kShutdown);
  EXPECT_EQ(daemon.receive(), R"({"jsonrpc":"2.0","id":"s","result":null})");
  daemon.send(kExit);
  EXPECT_EQ(daemon.exit_status(), 0);
  EXPECT_EQ(daemon.receive(), "");
}

TEST(LspProcess, ExitAloneEndsWithStatus1) {
  Daemon daemon;
  daemon.send(kExit);
  EXPECT_EQ(daemon.exit_status(), 1);
}

TEST(LspProcess, TheEndOfTheInputEndsIt) {
  Daemon before;
  before.close_input();
  EXPECT_EQ(before.exit_status(), 1);

  Daemon after;
  after.send(initialize(getpid()));
  after.send(kShutdown);
  after.close_input();
  EXPECT_EQ(after.exit_status(), 0);
}

TEST(LspProcess, HalfAMessageThenTheEnd) {
  Daemon daemon;
  daemon.send(initialize(getpid()));
  daemon.send_bytes("Content-Length: 1000\r\n\r\n{\"jsonrpc\"");
  daemon.close_input();
  EXPECT_NE(daemon.receive().find("\"capabilities\""), std::string::npos);
  EXPECT_EQ(daemon.receive(), "");
  EXPECT_EQ(daemon.exit_status(), 1);
}

TEST(LspProcess, GarbageIsAnsweredAndSkipped) {
  Daemon daemon;
  std::string garbage = "GET / HTTP/1.1\r\n\r\n";
  for (int i = 0; i < 100000; ++i) garbage += static_cast<char>(i * 7919 >> 3);
  daemon.send_bytes(garbage + "\r\n\r\n");
  daemon.send_bytes("Content-Length: 4\r\n\r\n{bad");
  daemon.send(initialize(getpid()));
  std::string reply = daemon.receive();
  int errors = 0;
  for (; reply.find("-32700") != std::string::npos; reply = daemon.receive()) ++errors;
  EXPECT_GE(errors, 2);
  EXPECT_NE(reply.find("\"capabilities\""), std::string::npos);
}

TEST(LspProcess, AClientThatNoLongerReadsEndsIt) {
  Daemon daemon;
  daemon.close_output();
  daemon.send(initialize(getpid()));
  EXPECT_EQ(daemon.exit_status(), 1);
}

/// Somebody else still holds the pipes open, but the process that started the daemon is gone.
TEST(LspProcess, TheDeathOfTheClientEndsIt) {
  const pid_t client = fork();
  if (client == 0) {
    pause();
    _exit(0);
  }
  Daemon daemon;
  daemon.send(initialize(client));
  EXPECT_NE(daemon.receive().find("\"capabilities\""), std::string::npos);
  kill(client, SIGKILL);
  waitpid(client, nullptr, 0);
  EXPECT_EQ(daemon.exit_status(), 1);
}

/// Two full pipes must not block each other: a thousand large answers are wanted before the first is read.
TEST(LspProcess, AClientThatWritesBeforeItReads) {
  Daemon daemon;
  daemon.send(initialize(getpid()));
  const std::string unknown(2000, 'x');
  for (int i = 1; i <= 1000; ++i) {
    daemon.send(R"({"jsonrpc":"2.0","id":)" + std::to_string(i) + R"(,"method":")" + unknown + R"("})");
  }
  EXPECT_NE(daemon.receive().find("\"id\":0"), std::string::npos);
  for (int i = 1; i <= 1000; ++i) {
    ASSERT_NE(daemon.receive().find("\"id\":" + std::to_string(i) + ","), std::string::npos) << i;
  }
}

std::string edit(int version, std::string_view equation) {
  return R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":"u","version":)" +
         std::to_string(version) + R"(},"contentChanges":[{"text":"\\begin{equation})" + std::string(equation) +
         R"(\\end{equation}"}]}})";
}

/// Edits that nobody waits for: the last publish is right, and there are fewer of them than edits.
TEST(LspProcess, ABurstOfEditsEndsInOneRightPublish) {
  constexpr int kEdits = 500;
  Daemon daemon;
  daemon.send(initialize(getpid()));
  daemon.send(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":)"
              R"({"uri":"u","languageId":"latex","version":0,"text":""}}})");
  std::string bytes;
  for (int version = 1; version < kEdits; ++version)
    bytes += lsp::frame(edit(version, "f = zz + " + std::to_string(version)));
  daemon.send_bytes(bytes + lsp::frame(edit(kEdits, "f = 1")));
  EXPECT_NE(daemon.receive().find("\"capabilities\""), std::string::npos);
  int published = 1;
  std::string last = daemon.receive();
  for (; last.find(R"("version":500,)") == std::string::npos; last = daemon.receive()) {
    ASSERT_NE(last.find("publishDiagnostics"), std::string::npos) << last;
    ++published;
  }
  EXPECT_LT(published, kEdits);
  EXPECT_NE(last.find(R"("version":500,"diagnostics":[])"), std::string::npos) << last;
  daemon.send(kShutdown);
  EXPECT_EQ(daemon.receive(), R"({"jsonrpc":"2.0","id":"s","result":null})");
}

}  // namespace
}  // namespace texbrdf::test

#include "render/worker.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <future>
#include <memory>
#include <optional>
#include <thread>

#include "render/gpu_renderer.h"

namespace texbrdf::render {

namespace {

constexpr int kFine = 0;
constexpr int kBadConnection = 1;

/// A renderer, or why there is none.
using Renderer = Result<GpuRenderer>;

/// Before the first GL call of the process.
void prepare_process() {
  // llvmpipe compiles a shader in a quarter of the time without its optimiser; a frame hardly notices.
  setenv("GALLIVM_PERF", "nopt", 0);
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

/// Moves the connection off the standard streams, which drivers write to: their words go to standard error.
int take_over(int fd, int replacement) {
  if (fd > STDERR_FILENO) return fd;
  const int moved = fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (moved < 0) return fd;
  dup2(replacement, fd);
  return moved;
}

/// A driver cannot be interrupted, so the end of the other side ends the process whatever it is doing.
void exit_with_parent(int in_fd) {
  std::thread([in_fd] {
    pollfd entry{in_fd, POLLRDHUP, 0};
    while (poll(&entry, 1, -1) < 0 || (entry.revents & (POLLHUP | POLLRDHUP | POLLERR)) == 0) {
    }
    _exit(kFine);
  }).detach();
}

/// glslang's tables and the driver are made ready side by side.
Renderer make_renderer() {
  auto checker = std::async(std::launch::async, [] { return std::make_unique<const GlslChecker>(); });
  Result<EglContext> context = EglContext::create();
  if (!context) return Failure{context.error()};
  return GpuRenderer::create(*std::move(context), checker.get());
}

template <typename Answer>
Message encode_either(const std::variant<Answer, Refusal>& answer) {
  return std::visit([](const auto& either) { return encode(either); }, answer);
}

/// Nothing where the message is no request.
std::optional<Message> answer(GpuRenderer& renderer, const Message& message) {
  if (const auto request = decode<DrawRequest>(message)) return encode_either(renderer.answer(*request));
  if (const auto request = decode<EvaluateRequest>(message)) return encode_either(renderer.answer(*request));
  if (const auto request = decode<SceneRequest>(message)) return encode_either(renderer.answer(*request));
  return std::nullopt;
}

bool send(int fd, const Message& message) {
  return std::holds_alternative<std::monostate>(send_message(fd, message.kind, message.payload, kNoDeadline));
}

int refuse_and_end(int out_fd, const std::string& what) {
  send(out_fd, encode(Refusal{RefusalKind::Request, "the render worker was sent " + what}));
  return kBadConnection;
}

}  // namespace

int run_render_worker(int in_fd, int out_fd) {
  prepare_process();
  const int null_fd = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int in = take_over(in_fd, null_fd);
  const int out = take_over(out_fd, STDERR_FILENO);
  exit_with_parent(in);

  Renderer renderer = make_renderer();
  if (!renderer) {
    send(out, encode(Greeting{false, renderer.error()}));
    return kFine;
  }
  if (!send(out, encode(Greeting{true, renderer->description()}))) return kBadConnection;
  while (true) {
    const auto received = receive_message(in, kNoDeadline);
    if (const auto* fault = std::get_if<ChannelFault>(&received)) {
      return fault->kind == ChannelFaultKind::Closed ? kFine : refuse_and_end(out, fault->message);
    }
    const auto reply = answer(*renderer, std::get<Message>(received));
    if (!reply) return refuse_and_end(out, "a message that is no request");
    if (!send(out, *reply)) return kBadConnection;
  }
}

}  // namespace texbrdf::render

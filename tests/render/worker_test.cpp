#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <thread>

#include "render/protocol.h"
#include "support.h"

// What may go wrong with the worker, and that its client tells it, restarts it and goes on.

namespace texbrdf::render {
namespace {

using namespace std::chrono_literals;
using test::expect_picture;
using test::worker_options;

const ShaderModel& lambert() {
  static const ShaderModel model{
      "uniform float albedo;\n"
      "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(albedo / 3.1415927); }\n",
      {{"albedo", 1, {0.5F, 0, 0}}}};
  return model;
}

/// llvmpipe cuts a loop off at 65 535 rounds, so there are three; even so 256² pixels may be done in a few seconds.
const ShaderModel& endless() {
  static const ShaderModel model{
      "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n"
      "  float x = N.x;\n"
      "  for (int i = 0; i < 65000; ++i) for (int j = 0; j < 65000; ++j) for (int k = 0; k < 65000; ++k)\n"
      "    x = sin(x + float(i ^ j ^ k));\n"
      "  return vec3(x);\n"
      "}\n",
      {}};
  return model;
}

RenderFault expect_fault(const std::variant<GpuPicture, RenderFault>& result) {
  const auto* fault = std::get_if<RenderFault>(&result);
  if (fault == nullptr) ADD_FAILURE() << "there is a picture";
  return fault == nullptr ? RenderFault{} : *fault;
}

std::ptrdiff_t open_files() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

bool has_children() {
  siginfo_t state{};
  return waitid(P_ALL, 0, &state, WEXITED | WNOHANG | WNOWAIT) == 0;
}

/// A worker that says and does what a shell script says.
WorkerOptions fake_worker(const std::string& script, std::chrono::milliseconds deadline = 5s) {
  return {.executable = "/bin/sh", .arguments = {"-c", script}, .environment = {}, .deadline = deadline};
}

/// Octal escapes for printf.
std::string escaped(const Message& message) {
  std::vector<uint8_t> bytes{'T', 'X', 'B', 'R'};
  for (const uint32_t word : {message.kind, static_cast<uint32_t>(message.payload.size())}) {
    for (const int shift : {0, 8, 16, 24}) bytes.push_back(static_cast<uint8_t>(word >> shift));
  }
  bytes.insert(bytes.end(), message.payload.begin(), message.payload.end());
  std::string text;
  for (const uint8_t byte : bytes) {
    text += '\\';
    for (const int shift : {6, 3, 0}) text += static_cast<char>('0' + (byte >> shift & 7));
  }
  return text;
}

std::string greets() {
  return "printf '" + escaped(encode(Greeting{true, "fake"})) + "'; ";
}

TEST(Worker, DrawsAndCompilesOnlyOnce) {
  RenderWorker worker(worker_options());
  worker.warm_up();
  ShaderModel model = lambert();
  const GpuPicture first = expect_picture(worker.draw(model, {}));
  EXPECT_TRUE(first.compiled);
  EXPECT_FALSE(worker.renderer().empty());
  EXPECT_EQ(first.picture.image.width, 256U);
  EXPECT_EQ(first.picture.bad_pixels.total(), 0U);

  model.uniforms[0].value[0] = 0.9F;
  const GpuPicture second = expect_picture(worker.draw(model, {}));
  EXPECT_FALSE(second.compiled) << "a parameter is a uniform";
  EXPECT_GT(second.picture.image.at(100, 100)[0], first.picture.image.at(100, 100)[0]);
  EXPECT_TRUE(worker.take_faults().empty());
}

TEST(Worker, DrawsEverySize) {
  RenderWorker worker(worker_options());
  for (const uint32_t size : {1U, 2U, 3U, 31U, 64U, 777U}) {
    const GpuPicture drawn = expect_picture(worker.draw(lambert(), {.size = size}));
    EXPECT_EQ(drawn.picture.image.pixels.size(), std::size_t{size} * size * 4);
    EXPECT_GT(drawn.picture.image.at(size / 2, size / 2)[3], 100);
  }
}

TEST(Worker, ALightFromBehindDrawsABlackDisc) {
  RenderWorker worker(worker_options());
  const GpuPicture drawn = expect_picture(worker.draw(lambert(), {.size = 32, .theta = 180}));
  EXPECT_EQ(drawn.picture.image.at(16, 16)[0], 0);
  EXPECT_EQ(drawn.picture.image.at(16, 16)[3], 255);
}

TEST(Worker, KilledWhileIdleIsToldAndReplaced) {
  RenderWorker worker(worker_options());
  expect_picture(worker.draw(lambert(), {.size = 32}));
  const int first = worker.process_id();
  ASSERT_EQ(kill(first, SIGKILL), 0);
  siginfo_t end{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(first), &end, WEXITED | WNOWAIT), 0);
  expect_picture(worker.draw(lambert(), {.size = 32}));
  EXPECT_NE(worker.process_id(), first);
  const auto faults = worker.take_faults();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, RenderFaultKind::Crash);
  EXPECT_EQ(faults[0].message, "the render worker was killed by signal 9 (Killed) between two requests");
}

TEST(Worker, KilledInTheMiddleOfAFrameIsToldAndReplaced) {
  RenderWorker worker(worker_options());
  expect_picture(worker.draw(lambert(), {.size = 32}));
  std::thread killer([process = worker.process_id()] {
    std::this_thread::sleep_for(300ms);
    kill(process, SIGKILL);
  });
  const RenderFault fault = expect_fault(worker.draw(endless(), {}));
  killer.join();
  EXPECT_EQ(fault.kind, RenderFaultKind::Crash);
  EXPECT_EQ(fault.message, "the render worker was killed by signal 9 (Killed) while drawing");
  expect_picture(worker.draw(lambert(), {.size = 32}));
}

TEST(Worker, AHangMeetsTheDeadlineAndLeavesNothingBehind) {
  const auto files = open_files();
  {
    WorkerOptions options = worker_options();
    options.deadline = 3s;
    RenderWorker worker(options);
    const auto start = Clock::now();
    const RenderFault fault = expect_fault(worker.draw(endless(), {.size = 1024}));
    EXPECT_LT(Clock::now() - start, 5s);
    EXPECT_EQ(fault.kind, RenderFaultKind::Deadline);
    EXPECT_EQ(fault.message,
              "the render worker gave no answer within 3000 ms while drawing, and was killed by signal 9 (Killed)");
    EXPECT_FALSE(has_children()) << "the killed worker is reaped";
    EXPECT_EQ(open_files(), files);
    expect_picture(worker.draw(lambert(), {.size = 32}));
  }
  EXPECT_FALSE(has_children());
  EXPECT_EQ(open_files(), files);
}

TEST(Worker, AShaderThatIsNoneIsToldAndTheWorkerGoesOn) {
  RenderWorker worker(worker_options());
  const RenderFault fault =
      expect_fault(worker.draw({"vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return 1; }", {}}, {}));
  EXPECT_EQ(fault.kind, RenderFaultKind::Shader);
  EXPECT_NE(fault.message.find("glslang rejects the shader: 0:1:"), std::string::npos) << fault.message;
  const int process = worker.process_id();
  expect_picture(worker.draw(lambert(), {.size = 32}));
  EXPECT_EQ(worker.process_id(), process);
}

TEST(Worker, AViewThatCannotBeDrawnIsRefused) {
  RenderWorker worker(worker_options());
  EXPECT_EQ(expect_fault(worker.draw(lambert(), {.size = 0})).kind, RenderFaultKind::Request);
  EXPECT_EQ(worker.process_id(), -1) << "no worker is needed to say so";
}

TEST(Worker, WithoutOpenGlThereIsNoRenderer) {
  RenderWorker worker(worker_options({"TEXBRDF_EGL=none"}));
  const RenderFault fault = expect_fault(worker.draw(lambert(), {}));
  EXPECT_EQ(fault.kind, RenderFaultKind::NoRenderer);
  EXPECT_EQ(fault.message, "the renderer is switched off by TEXBRDF_EGL=none");
}

TEST(Worker, AnUnknownPlatformIsNoRenderer) {
  RenderWorker worker(worker_options({"TEXBRDF_EGL=cinema"}));
  const RenderFault fault = expect_fault(worker.draw(lambert(), {}));
  EXPECT_EQ(fault.kind, RenderFaultKind::NoRenderer);
  EXPECT_NE(fault.message.find("no OpenGL 3.3 through EGL"), std::string::npos) << fault.message;
}

TEST(Worker, TheDevicePlatformDrawsTheSamePicture) {
  RenderWorker surfaceless(worker_options({"TEXBRDF_EGL=surfaceless"}));
  RenderWorker device(worker_options({"TEXBRDF_EGL=device"}));
  const GpuPicture a = expect_picture(surfaceless.draw(lambert(), {.size = 64}));
  const GpuPicture b = expect_picture(device.draw(lambert(), {.size = 64}));
  EXPECT_NE(device.renderer().find("EGL device"), std::string::npos) << device.renderer();
  EXPECT_EQ(a.picture.image.pixels, b.picture.image.pixels);
}

TEST(Worker, AMissingProgramIsNoRenderer) {
  WorkerOptions options;
  options.executable = "/nonexistent/texbrdf";
  RenderWorker worker(options);
  EXPECT_EQ(expect_fault(worker.draw(lambert(), {})).kind, RenderFaultKind::NoRenderer);
}

struct Nonsense {
  std::string name;
  std::string script;
  RenderFaultKind kind;
  std::string words;
};

void PrintTo(const Nonsense& nonsense, std::ostream* stream) {
  *stream << nonsense.name;
}

class FakeWorker : public testing::TestWithParam<Nonsense> {};

TEST_P(FakeWorker, IsToldAndReaped) {
  const auto files = open_files();
  RenderWorker worker(fake_worker(GetParam().script, 2s));
  const auto start = Clock::now();
  const RenderFault fault = expect_fault(worker.draw(lambert(), {.size = 2}));
  EXPECT_LT(Clock::now() - start, 4s);
  EXPECT_EQ(fault.kind, GetParam().kind);
  EXPECT_NE(fault.message.find(GetParam().words), std::string::npos) << fault.message;
  EXPECT_EQ(worker.process_id(), -1);
  EXPECT_FALSE(has_children());
  EXPECT_EQ(open_files(), files);
}

Message picture_of_size(uint32_t size) {
  DrawAnswer answer;
  answer.picture.image = {size, size, std::vector<uint8_t>(std::size_t{size} * size * 4)};
  return encode(answer);
}

INSTANTIATE_TEST_SUITE_P(
    Worker, FakeWorker,
    testing::Values(
        Nonsense{"silent", "exec sleep 100", RenderFaultKind::Deadline, "within 2000 ms while starting"},
        Nonsense{"chatty", "exec yes", RenderFaultKind::Protocol, "bytes that are no message while starting"},
        Nonsense{"ends", "exit 3", RenderFaultKind::Crash, "ended with code 3 while starting"},
        Nonsense{"crashes", "kill -SEGV $$", RenderFaultKind::Crash, "killed by signal 11"},
        Nonsense{"huge", "printf 'TXBR\\001\\000\\000\\000\\377\\377\\377\\377'; exec sleep 100",
                 RenderFaultKind::Protocol, "a message of 4294967295 bytes"},
        Nonsense{"greets_with_an_answer", "printf '" + escaped(encode(EvaluateAnswer{})) + "'; exec sleep 100",
                 RenderFaultKind::Protocol, "no greeting"},
        Nonsense{"never_reads", greets() + "exec sleep 100", RenderFaultKind::Deadline, "within 2000 ms while drawing"},
        Nonsense{"answers_nonsense", greets() + "printf 'TXBR\\144\\000\\000\\000\\000\\000\\000\\000'; exec sleep 100",
                 RenderFaultKind::Protocol, "no answer"},
        Nonsense{"stops_halfway", greets() + "printf 'TXBR\\004\\000\\000\\000\\000\\001\\000\\000abc'; exec sleep 100",
                 RenderFaultKind::Deadline, "while drawing"},
        Nonsense{"wrong_size", greets() + "printf '" + escaped(picture_of_size(3)) + "'; exec sleep 100",
                 RenderFaultKind::Protocol, "a picture of another size"}),
    [](const auto& test) { return test.param.name; });

TEST(Worker, FailuresInARowAreTriedMoreSlowly) {
  RenderWorker worker(fake_worker("exit 1"));
  const auto timed = [&] {
    const auto start = Clock::now();
    expect_fault(worker.draw(lambert(), {}));
    return Clock::now() - start;
  };
  timed();
  timed();
  EXPECT_GE(timed(), 90ms);
  EXPECT_GE(timed(), 190ms);
  EXPECT_EQ(worker.take_faults().size(), 4U);
}

TEST(Worker, ABackOffLongerThanTheDeadlineIsToldAtOnce) {
  RenderWorker worker(fake_worker("exit 1", 50ms));
  expect_fault(worker.draw(lambert(), {}));
  expect_fault(worker.draw(lambert(), {}));
  const auto start = Clock::now();
  const RenderFault fault = expect_fault(worker.draw(lambert(), {}));
  EXPECT_LT(Clock::now() - start, 45ms);
  EXPECT_NE(fault.message.find("failed 2 times in a row"), std::string::npos) << fault.message;
}

class RealWorkerSent : public testing::TestWithParam<std::string> {};

/// The other direction: garbage sent to the real worker. It answers with a refusal and ends, and does not hang.
TEST_P(RealWorkerSent, GarbageEndsWithARefusal) {
  const std::string script =
      "printf '" + GetParam() + "' | timeout 20 " TEXBRDF_RENDER_WORKER " >/dev/null; test $? -ne 124";
  EXPECT_EQ(std::system(script.c_str()), 0);
}

INSTANTIATE_TEST_SUITE_P(Worker, RealWorkerSent,
                         testing::Values("", "hello", "hello, this is no message", "TXBR", "TXBR\\001\\002",
                                         "TXBR\\002\\000\\000\\000\\377\\377\\377\\377",
                                         "TXBR\\002\\000\\000\\000\\002\\000\\000\\000ab",
                                         "TXBR\\143\\000\\000\\000\\000\\000\\000\\000"));

TEST(Worker, EndsWithItsParentEvenInTheMiddleOfAFrame) {
  // A shell stands for the parent: it starts the worker, asks for a frame that never ends, and dies.
  const std::string request = escaped(encode(DrawRequest{endless(), {}}));
  const std::string script = "{ printf '" + request + "'; sleep 1; } | " TEXBRDF_RENDER_WORKER " >/dev/null";
  const auto start = Clock::now();
  EXPECT_EQ(std::system(("timeout 20 sh -c \"" + script + "\"").c_str()), 0);
  EXPECT_LT(Clock::now() - start, 15s);
}

}  // namespace
}  // namespace texbrdf::render

#include "render/worker_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "render/child_process.h"
#include "render/protocol.h"

namespace texbrdf::render {

namespace {

using namespace std::chrono_literals;

constexpr auto kFirstBackOff = 100ms;
constexpr auto kLongestBackOff = 5'000ms;
constexpr std::size_t kMaxRememberedFaults = 16;
/// Geometries in one request.
constexpr std::size_t kEvaluateStep = 65'536;
constexpr std::size_t kMaxSourceBytes = std::size_t{8} << 20;

/// The first restart is at once; each further one in a row waits twice as long.
std::chrono::milliseconds back_off(uint32_t faults_in_a_row) {
  if (faults_in_a_row < 2) return 0ms;
  const uint32_t doublings = std::min(faults_in_a_row - 2, 10U);
  return std::min<std::chrono::milliseconds>(kFirstBackOff * (1U << doublings), kLongestBackOff);
}

RenderFaultKind fault_kind(ChannelFaultKind kind) {
  switch (kind) {
    case ChannelFaultKind::Closed:
      return RenderFaultKind::Crash;
    case ChannelFaultKind::Deadline:
      return RenderFaultKind::Deadline;
    case ChannelFaultKind::Garbage:
      return RenderFaultKind::Protocol;
  }
  return RenderFaultKind::Protocol;
}

RenderFaultKind fault_kind(RefusalKind kind) {
  switch (kind) {
    case RefusalKind::Request:
      return RenderFaultKind::Request;
    case RefusalKind::Shader:
      return RenderFaultKind::Shader;
    case RefusalKind::Renderer:
      return RenderFaultKind::Crash;
  }
  return RenderFaultKind::Protocol;
}

EvaluateRequest evaluate_request(const ShaderModel& model, std::span<const eval::Geometry> geometries) {
  EvaluateRequest request{model, {}};
  const auto append = [&](std::size_t first_list, const std::array<double, 3>& vector) {
    for (std::size_t c = 0; c < 3; ++c) request.geometry[first_list + c].push_back(static_cast<float>(vector[c]));
  };
  for (const eval::Geometry& geometry : geometries) {
    append(0, geometry.light);
    append(3, geometry.view);
    append(6, geometry.normal);
    append(9, geometry.tangent);
    append(12, geometry.bitangent);
  }
  return request;
}

}  // namespace

struct RenderWorker::State {
  explicit State(WorkerOptions worker_options) : options(std::move(worker_options)) {}

  WorkerOptions options;
  std::optional<ChildProcess> child;
  bool greeted = false;
  std::string renderer;
  uint32_t faults_in_a_row = 0;
  Clock::time_point not_before{};
  std::vector<RenderFault> faults;

  RenderFault note(RenderFault fault);
  RenderFault lose_child(RenderFaultKind kind, std::string_view what);
  RenderFault lose_child(const ChannelFault& fault, std::string_view doing);
  void notice_idle_death();
  std::optional<RenderFault> start(Clock::time_point deadline);
  std::optional<RenderFault> greet(Clock::time_point deadline);
  std::variant<Message, RenderFault> exchange(const Message& request);
  std::variant<Message, RenderFault> ask(const Message& request, Clock::time_point deadline);
  template <typename Answer>
  std::variant<Answer, RenderFault> answer(const Message& request);
  std::variant<std::vector<float>, RenderFault> evaluate(const EvaluateRequest& request);
};

RenderFault RenderWorker::State::note(RenderFault fault) {
  if (faults.size() == kMaxRememberedFaults) faults.erase(faults.begin());
  faults.push_back(fault);
  return fault;
}

/// Ends the child and makes the next start wait.
RenderFault RenderWorker::State::lose_child(RenderFaultKind kind, std::string_view what) {
  child.reset();
  greeted = false;
  ++faults_in_a_row;
  not_before = Clock::now() + back_off(faults_in_a_row);
  return note({kind, std::string(what)});
}

RenderFault RenderWorker::State::lose_child(const ChannelFault& fault, std::string_view doing) {
  const std::string end = child->finish();
  switch (fault.kind) {
    case ChannelFaultKind::Closed:
      return lose_child(fault_kind(fault.kind), fmt::format("the render worker {} while {}", end, doing));
    case ChannelFaultKind::Deadline:
      return lose_child(fault_kind(fault.kind),
                        fmt::format("the render worker gave no answer within {} ms while {}, and {}",
                                    options.deadline.count(), doing, end));
    case ChannelFaultKind::Garbage:
      return lose_child(fault_kind(fault.kind),
                        fmt::format("the render worker sent {} while {}, and {}", fault.message, doing, end));
  }
  return lose_child(RenderFaultKind::Protocol, fault.message);
}

void RenderWorker::State::notice_idle_death() {
  if (!child || !child->has_ended()) return;
  const std::string end = child->finish();
  lose_child(RenderFaultKind::Crash, fmt::format("the render worker {} between two requests", end));
}

std::optional<RenderFault> RenderWorker::State::start(Clock::time_point deadline) {
  if (not_before > deadline) {
    return note({RenderFaultKind::Deadline, fmt::format("the render worker failed {} times in a row and is not started "
                                                        "again before the deadline",
                                                        faults_in_a_row)});
  }
  std::this_thread::sleep_until(not_before);
  Result<ChildProcess> started = ChildProcess::start(options.executable, options.arguments, options.environment);
  if (!started) return lose_child(RenderFaultKind::NoRenderer, started.error());
  child = *std::move(started);
  return std::nullopt;
}

std::optional<RenderFault> RenderWorker::State::greet(Clock::time_point deadline) {
  const auto received = receive_message(child->socket(), deadline);
  if (const auto* fault = std::get_if<ChannelFault>(&received)) return lose_child(*fault, "starting");
  const auto greeting = decode<Greeting>(std::get<Message>(received));
  if (!greeting) return lose_child({ChannelFaultKind::Garbage, "a message that is no greeting"}, "starting");
  if (!greeting->has_renderer) return lose_child(RenderFaultKind::NoRenderer, greeting->text);
  renderer = greeting->text;
  greeted = true;
  return std::nullopt;
}

std::variant<Message, RenderFault> RenderWorker::State::ask(const Message& request, Clock::time_point deadline) {
  const auto sent = send_message(child->socket(), request.kind, request.payload, deadline);
  if (const auto* fault = std::get_if<ChannelFault>(&sent)) return lose_child(*fault, "taking a request");
  const auto received = receive_message(child->socket(), deadline);
  if (const auto* fault = std::get_if<ChannelFault>(&received)) return lose_child(*fault, "drawing");
  return std::get<Message>(received);
}

std::variant<Message, RenderFault> RenderWorker::State::exchange(const Message& request) {
  const Clock::time_point deadline = Clock::now() + options.deadline;
  if (request.payload.size() > kMaxPayloadBytes) {
    return note({RenderFaultKind::Request, "the request is too large for the render worker"});
  }
  notice_idle_death();
  if (!child) {
    if (auto fault = start(deadline)) return *fault;
  }
  if (!greeted) {
    if (auto fault = greet(deadline)) return *fault;
  }
  return ask(request, deadline);
}

template <typename Answer>
std::variant<Answer, RenderFault> RenderWorker::State::answer(const Message& request) {
  const auto received = exchange(request);
  if (const auto* fault = std::get_if<RenderFault>(&received)) return *fault;
  const Message& message = std::get<Message>(received);
  if (auto answer = decode<Answer>(message)) {
    faults_in_a_row = 0;
    return *std::move(answer);
  }
  const auto refusal = decode<Refusal>(message);
  if (!refusal) return lose_child({ChannelFaultKind::Garbage, "a message that is no answer"}, "drawing");
  if (refusal->kind == RefusalKind::Renderer) return lose_child(fault_kind(refusal->kind), refusal->message);
  return note({fault_kind(refusal->kind), refusal->message});
}

std::variant<std::vector<float>, RenderFault> RenderWorker::State::evaluate(const EvaluateRequest& request) {
  auto received = answer<EvaluateAnswer>(encode(request));
  if (const auto* fault = std::get_if<RenderFault>(&received)) return *fault;
  std::vector<float>& values = std::get<EvaluateAnswer>(received).values;
  if (values.size() == request.geometry[0].size() * 3) return std::move(values);
  return lose_child({ChannelFaultKind::Garbage, "another number of values"}, "evaluating");
}

RenderWorker::RenderWorker(WorkerOptions options) : state_(std::make_unique<State>(std::move(options))) {}
RenderWorker::RenderWorker(RenderWorker&&) noexcept = default;
RenderWorker& RenderWorker::operator=(RenderWorker&&) noexcept = default;
RenderWorker::~RenderWorker() = default;

void RenderWorker::warm_up() {
  state_->notice_idle_death();
  if (!state_->child && Clock::now() >= state_->not_before) static_cast<void>(state_->start(kNoDeadline));
}

std::variant<GpuPicture, RenderFault> RenderWorker::draw(const ShaderModel& model, const SphereView& view) {
  if (const auto fault = find_fault(view)) return state_->note({RenderFaultKind::Request, *fault});
  if (model.source.size() > kMaxSourceBytes) {
    return state_->note({RenderFaultKind::Request, "the generated shader is too large to be drawn"});
  }
  auto answer = state_->answer<DrawAnswer>(encode(DrawRequest{model, view}));
  if (const auto* fault = std::get_if<RenderFault>(&answer)) return *fault;
  auto& drawn = std::get<DrawAnswer>(answer);
  if (drawn.picture.image.width != view.size || drawn.picture.image.height != view.size) {
    return state_->lose_child({ChannelFaultKind::Garbage, "a picture of another size"}, "drawing");
  }
  return GpuPicture{std::move(drawn.picture), drawn.milliseconds, drawn.compiled};
}

std::variant<std::vector<std::array<float, 3>>, RenderFault> RenderWorker::evaluate(
    const ShaderModel& model, std::span<const eval::Geometry> geometries) {
  std::vector<std::array<float, 3>> values;
  values.reserve(geometries.size());
  while (!geometries.empty()) {
    const std::size_t count = std::min(kEvaluateStep, geometries.size());
    const auto evaluated = state_->evaluate(evaluate_request(model, geometries.first(count)));
    if (const auto* fault = std::get_if<RenderFault>(&evaluated)) return *fault;
    const std::vector<float>& numbers = std::get<std::vector<float>>(evaluated);
    for (std::size_t i = 0; i < count; ++i) values.push_back({numbers[i * 3], numbers[i * 3 + 1], numbers[i * 3 + 2]});
    geometries = geometries.subspan(count);
  }
  return values;
}

std::variant<SceneAnswer, RenderFault> RenderWorker::trace(const SceneRequest& request) {
  if (const auto fault = find_fault(request)) return state_->note({RenderFaultKind::Request, *fault});
  if (request.source.size() > kMaxSourceBytes) {
    return state_->note({RenderFaultKind::Request, "the shader of the scene is too large to be drawn"});
  }
  auto answer = state_->answer<SceneAnswer>(encode(request));
  if (const auto* drawn = std::get_if<SceneAnswer>(&answer)) {
    if (drawn->values.size() != request.tile.pixel_count() * 3) {
      return state_->lose_child({ChannelFaultKind::Garbage, "a tile of another size"}, "drawing");
    }
  }
  return answer;
}

std::variant<std::vector<float>, RenderFault> RenderWorker::evaluate_table(const ShaderModel& model,
                                                                           const GeometryTable& geometries) {
  return state_->evaluate({model, geometries});
}

std::vector<RenderFault> RenderWorker::take_faults() {
  return std::exchange(state_->faults, {});
}

const std::string& RenderWorker::renderer() const {
  return state_->renderer;
}

int RenderWorker::process_id() const {
  return state_->child ? state_->child->process_id() : -1;
}

}  // namespace texbrdf::render

#include "preview/scene_painter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "render/png.h"
#include "render/scene_picture.h"

namespace texbrdf::preview {
namespace {

using Clock = std::chrono::steady_clock;

/// Of one strip, or of compiling.
constexpr std::chrono::seconds kDeadline{60};
/// What a first picture may take, and a strip, after which it is looked whether anything newer is there.
constexpr double kQuickMilliseconds = 60;
constexpr double kStripMilliseconds = 100;
constexpr uint32_t kLeastSide = 48;

struct Slot {
  std::shared_ptr<const SceneShot> shot;
  uint64_t serial = 0;
  Clock::time_point begin;
  std::optional<render::ScenePicture> picture;  // with `samples` of each pixel, of the present shot
  uint32_t samples = 0;
  bool is_quick_done = false;
  bool is_over = false;  // it cannot be drawn, or has all samples
  uint64_t turn = 0;
  std::optional<SceneTrouble> trouble;
  std::optional<SceneFrame> ready;
  bool on_its_way = false;
};

/// What the thread is to draw next: one sample of each pixel.
struct Work {
  int64_t preview = 0;
  uint64_t serial = 0;
  std::shared_ptr<const SceneShot> shot;
  Clock::time_point begin;
  uint32_t sample = 0;
  bool is_quick_done = false;
  std::optional<render::ScenePicture> picture;  // so far
};

bool is_power_of_two(uint32_t number) {
  return (number & (number - 1)) == 0;
}

/// Only colours become better with more samples.
uint32_t all_samples(const SceneShot& shot) {
  return shot.look.view == render::SceneView::Shaded ? kMostPreviewSamples : 1;
}

SceneFrame make_frame(const Work& work, const render::ScenePicture& picture, uint32_t samples) {
  const SceneShot& shot = *work.shot;
  const render::Picture shown = picture.picture(shot.look.view, shot.display);
  SceneFrame frame{.preview = work.preview, .version = shot.version, .png = {}, .bad_pixels = shown.bad_pixels};
  frame.width = picture.width();
  frame.height = picture.height();
  frame.samples = samples;
  frame.all_samples = all_samples(shot);
  frame.view = shot.look.view;
  frame.is_current = shot.is_current;
  frame.png = render::encode_png(shown.image, render::PngEffort::Fast);
  frame.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - work.begin).count();
  return frame;
}

}  // namespace

/// All that is shared stands behind the mutex; it is not held while something is drawn.
class ScenePainter::Thread {
 public:
  Thread(std::function<void()> wake, render::WorkerOptions options)
      : wake_(std::move(wake)), worker_(with_deadline(std::move(options))), thread_([this] { run(); }) {}

  ~Thread() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    work_.notify_all();
    thread_.join();
  }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  void show(int64_t preview, SceneShot shot) {
    {
      const std::lock_guard lock(mutex_);
      Slot& slot = slots_[preview];
      slot.shot = std::make_shared<const SceneShot>(std::move(shot));
      slot.serial = ++last_serial_;
      slot.begin = Clock::now();
      slot.picture.reset();
      slot.samples = 0;
      slot.is_quick_done = false;
      slot.is_over = false;
    }
    work_.notify_all();
  }

  void acknowledge(int64_t preview) {
    const std::lock_guard lock(mutex_);
    if (const auto slot = slots_.find(preview); slot != slots_.end()) slot->second.on_its_way = false;
  }

  void close(int64_t preview) {
    const std::lock_guard lock(mutex_);
    slots_.erase(preview);
  }

  std::vector<SceneEvent> take_events() {
    const std::lock_guard lock(mutex_);
    std::vector<SceneEvent> events;
    for (auto& [preview, slot] : slots_) {
      if (slot.trouble) events.emplace_back(*std::exchange(slot.trouble, std::nullopt));
      if (!slot.ready || slot.on_its_way) continue;
      events.emplace_back(*std::exchange(slot.ready, std::nullopt));
      slot.on_its_way = true;
    }
    return events;
  }

 private:
  static render::WorkerOptions with_deadline(render::WorkerOptions options) {
    options.deadline = kDeadline;
    return options;
  }

  /// A preview without a picture of its shot comes first, then the one that has waited longest.
  std::optional<Work> next() {
    Slot* first = nullptr;
    int64_t preview = 0;
    const auto rank = [](const Slot& slot) { return std::pair(slot.samples > 0, slot.turn); };
    for (auto& [id, slot] : slots_) {
      if (slot.is_over || (first != nullptr && rank(*first) <= rank(slot))) continue;
      first = &slot;
      preview = id;
    }
    if (first == nullptr) return std::nullopt;
    first->turn = ++last_turn_;
    return Work{preview,
                first->serial,
                first->shot,
                first->begin,
                first->samples,
                first->is_quick_done,
                std::exchange(first->picture, std::nullopt)};
  }

  std::optional<Work> wait_for_work() {
    std::unique_lock lock(mutex_);
    std::optional<Work> work;
    work_.wait(lock, [&] { return is_ending_ || (work = next()).has_value(); });
    return is_ending_ ? std::nullopt : std::move(work);
  }

  void run() {
    while (std::optional<Work> work = wait_for_work()) {
      try {
        if (const auto fault = draw(*work)) give_up(*work, *fault);
      } catch (const std::exception& fault) {
        give_up(*work, {render::RenderFaultKind::Protocol, fault.what()});
      }
      wake_();
    }
  }

  std::optional<render::RenderFault> draw(Work& work) {
    const SceneShot& shot = *work.shot;
    const double scale = quick_scale(shot);
    const bool is_quick = work.sample == 0 && !work.is_quick_done && scale < 1;
    const auto side = [&](uint32_t whole) {
      const auto part = static_cast<uint32_t>(std::lround(whole * scale));
      return is_quick ? std::clamp(part, std::min(whole, kLeastSide), whole) : whole;
    };
    if (!work.picture) work.picture.emplace(side(shot.width), side(shot.height));
    const auto drawn = trace(work);
    if (const auto* fault = std::get_if<render::RenderFault>(&drawn)) return *fault;
    if (std::get<bool>(drawn)) deposit(work, is_quick);
    return std::nullopt;
  }

  /// How much smaller a first picture is in each direction.
  double quick_scale(const SceneShot& shot) const {
    const double expected = milliseconds_a_pixel_ * shot.width * shot.height;
    return expected <= 2 * kQuickMilliseconds ? 1 : std::sqrt(kQuickMilliseconds / expected);
  }

  /// One sample of each pixel, in strips; false where something newer came between.
  std::variant<bool, render::RenderFault> trace(Work& work) {
    const SceneShot& shot = *work.shot;
    render::ScenePicture& picture = *work.picture;
    const uint32_t width = picture.width();
    const render::SceneTile whole{width, picture.height(), 0, 0, width, picture.height()};
    render::SceneRequest request{shot.shader->source, shot.state, shot.look, whole, render::scene_sample(work.sample)};
    for (uint32_t y = 0; y < picture.height(); y += request.tile.height) {
      request.tile.y = y;
      request.tile.height = std::min(strip_height(width), picture.height() - y);
      const auto answer = worker_.trace(request);
      if (const auto* fault = std::get_if<render::RenderFault>(&answer)) return *fault;
      const auto& drawn = std::get<render::SceneAnswer>(answer);
      picture.add(request.tile, drawn.values);
      if (!drawn.compiled) milliseconds_a_pixel_ = drawn.milliseconds / static_cast<double>(request.tile.pixel_count());
      if (!is_wanted(work)) return false;
    }
    return true;
  }

  uint32_t strip_height(uint32_t width) const {
    const double pixels =
        std::clamp(kStripMilliseconds / milliseconds_a_pixel_, 1024.0, static_cast<double>(render::kMaxTilePixels));
    return std::max(static_cast<uint32_t>(pixels) / width, 1U);
  }

  bool is_wanted(const Work& work) {
    const std::lock_guard lock(mutex_);
    const auto slot = slots_.find(work.preview);
    return !is_ending_ && slot != slots_.end() && slot->second.serial == work.serial;
  }

  void deposit(Work& work, bool is_quick) {
    const uint32_t samples = work.sample + 1;
    const bool is_shown = is_quick || is_power_of_two(samples);
    std::optional<SceneFrame> frame;
    if (is_shown) frame = make_frame(work, *work.picture, samples);
    const std::lock_guard lock(mutex_);
    const auto found = slots_.find(work.preview);
    if (found == slots_.end() || found->second.serial != work.serial) return;
    Slot& slot = found->second;
    if (frame) slot.ready = std::move(frame);
    if (is_quick) {
      slot.is_quick_done = true;
      return;
    }
    slot.picture = std::move(work.picture);
    slot.samples = samples;
    slot.is_over = samples >= all_samples(*work.shot);
  }

  void give_up(const Work& work, render::RenderFault fault) {
    const std::lock_guard lock(mutex_);
    const auto found = slots_.find(work.preview);
    if (found == slots_.end() || found->second.serial != work.serial) return;
    found->second.is_over = true;
    found->second.trouble = SceneTrouble{work.preview, work.shot->version, work.shot->shader, std::move(fault)};
  }

  std::function<void()> wake_;
  // Of the thread.
  render::RenderWorker worker_;
  double milliseconds_a_pixel_ = 0.005;

  std::mutex mutex_;
  std::condition_variable work_;
  std::map<int64_t, Slot> slots_;
  uint64_t last_serial_ = 0;
  uint64_t last_turn_ = 0;
  bool is_ending_ = false;
  std::thread thread_;
};

ScenePainter::ScenePainter(std::function<void()> wake, render::WorkerOptions options)
    : thread_(std::make_unique<Thread>(std::move(wake), std::move(options))) {}
ScenePainter::~ScenePainter() = default;

void ScenePainter::show(int64_t preview, SceneShot shot) {
  thread_->show(preview, std::move(shot));
}
void ScenePainter::acknowledge(int64_t preview) {
  thread_->acknowledge(preview);
}
void ScenePainter::close(int64_t preview) {
  thread_->close(preview);
}
std::vector<SceneEvent> ScenePainter::take_events() {
  return thread_->take_events();
}

}  // namespace texbrdf::preview

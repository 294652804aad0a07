#include "preview/preview_service.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "preview/cpu_frame.h"
#include "preview/object_painter.h"
#include "preview/recent_shader_models.h"
#include "render/png.h"

namespace texbrdf::preview {
namespace {

using Clock = std::chrono::steady_clock;

/// A larger picture is drawn on the CPU only where there is no GPU.
constexpr uint32_t kMaxQuickSize = 512;
constexpr uint32_t kMaxCpuSize = 1024;
constexpr std::chrono::milliseconds kHeadStart{5};
/// A picture that takes longer is given up as soon as another is waited for.
constexpr std::chrono::milliseconds kLongest{500};

/// A scene whose equations are linked.
struct Drawable {
  ir::Program program;
  CpuModel cpu;
};

/// A scene as one thread draws it.
struct Work {
  int64_t preview = 0;
  uint64_t serial = 0;  // of the scene
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Drawable> drawable;  // of the GPU's; else what was drawn before
  std::optional<uint64_t> linked_model;      // of the scene that `drawable` and `is_current` hold for
  Clock::time_point begin;
  bool is_current = true;
  uint32_t max_size = 0;  // of a picture of the CPU
};

struct Slot {
  std::shared_ptr<const Scene> scene;
  uint64_t serial = 0;        // of the scene
  uint64_t linked = 0;        // serial of the scene that `good` is drawn for
  uint64_t drawn_on_cpu = 0;  // serials
  uint64_t drawn_on_gpu = 0;
  uint64_t turn_on_cpu = 0;  // when it was drawn last; the one that has waited longest is next
  uint64_t turn_on_gpu = 0;
  Clock::time_point begin;
  std::shared_ptr<const Drawable> good;  // the last that could be drawn
  bool is_current = true;                // `good` is the scene's own
  std::optional<uint64_t> linked_model;  // of the scene that this was found for
  std::optional<SceneState> state;       // to be told
  std::optional<Frame> ready;
  bool more_on_cpu = false;  // samples are missing in what was drawn last
  bool more_on_gpu = false;
  bool lacks_files = false;                               // of an object or its light; told
  std::pair<uint64_t, Device> newest = {0, Device::Cpu};  // the serial of the last frame that was ready
  bool on_its_way = false;
};

Result<Drawable> make_drawable(const Scene& scene) {
  Result<ir::Program> program = scene_program(scene);
  if (!program) return Failure{program.error()};
  Result<CpuModel> cpu = cpu_model(*program);
  if (!cpu) return Failure{cpu.error()};
  return Drawable{*std::move(program), *std::move(cpu)};
}

Frame make_frame(const Work& work, Device device, const render::Picture& picture) {
  Frame frame{.preview = work.preview, .version = work.scene->version, .device = device, .png = {}, .bad_pixels = {}};
  frame.size = picture.image.width;
  frame.png = render::encode_png(picture.image, render::PngEffort::Fast);
  frame.bad_pixels = picture.bad_pixels;
  frame.is_current = work.is_current;
  frame.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - work.begin).count();
  return frame;
}

}  // namespace

/// All that is shared stands behind the mutex; no thread draws while it holds it.
class PreviewService::Painter {
 public:
  Painter(std::function<void()> wake, render::WorkerOptions options)
      : wake_(std::move(wake)), worker_(std::move(options)), cpu_([this] { run_cpu(); }), gpu_([this] { run_gpu(); }) {}

  ~Painter() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    work_.notify_all();
    cpu_.join();
    gpu_.join();
  }
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  void show(int64_t preview, Scene scene) {
    {
      const std::lock_guard lock(mutex_);
      Slot& slot = slots_[preview];
      slot.scene = std::make_shared<const Scene>(std::move(scene));
      slot.serial = ++last_serial_;
      slot.begin = Clock::now();
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

  std::vector<Event> take_events() {
    const std::lock_guard lock(mutex_);
    std::vector<Event> events;
    for (auto& [preview, slot] : slots_) {
      if (slot.state) events.emplace_back(*std::exchange(slot.state, std::nullopt));
      if (!slot.ready || slot.on_its_way) continue;
      events.emplace_back(*std::exchange(slot.ready, std::nullopt));
      slot.on_its_way = true;
    }
    return events;
  }

  std::vector<std::string> take_faults() {
    const std::lock_guard lock(mutex_);
    return std::exchange(faults_, {});
  }

 private:
  template <typename Next>
  std::optional<Work> wait_for_work(const Next& next) {
    std::unique_lock lock(mutex_);
    std::optional<Work> work;
    work_.wait(lock, [&] { return is_ending_ || (work = next()).has_value(); });
    return is_ending_ ? std::nullopt : std::move(work);
  }

  Work work_of(int64_t preview, const Slot& slot) const {
    const uint32_t max_size = has_no_gpu_ ? kMaxCpuSize : kMaxQuickSize;
    return {preview, slot.serial, slot.scene, slot.good, slot.linked_model, slot.begin, slot.is_current, max_size};
  }

  std::optional<Work> next_for_cpu() {
    return next(&Slot::turn_on_cpu,
                [](const Slot& slot) { return slot.drawn_on_cpu < slot.serial || slot.more_on_cpu; });
  }

  std::optional<Work> next_for_gpu() {
    if (has_no_gpu_) return std::nullopt;
    return next(&Slot::turn_on_gpu, [](const Slot& slot) {
      return slot.linked == slot.serial && slot.good && (slot.drawn_on_gpu < slot.serial || slot.more_on_gpu);
    });
  }

  template <typename Waits>
  std::optional<Work> next(uint64_t Slot::* turn, const Waits& waits) {
    auto first = slots_.end();
    for (auto slot = slots_.begin(); slot != slots_.end(); ++slot) {
      if (!waits(slot->second)) continue;
      if (first == slots_.end() || slot->second.*turn < first->second.*turn) first = slot;
    }
    if (first == slots_.end()) return std::nullopt;
    first->second.*turn = ++last_turn_;
    return work_of(first->first, first->second);
  }

  void run_cpu() {
    render::SphereCache cache;
    while (std::optional<Work> work = wait_for_work([this] { return next_for_cpu(); })) {
      try {
        link(*work);
        deposit(*work, Device::Cpu, draw_on_cpu(*work, cache));
      } catch (const std::exception& fault) {
        give_up(*work, Device::Cpu, fault);
        tell_fault(*std::move(work));
      }
    }
  }

  /// Where the scene cannot be drawn the last one that could stays.
  void link(Work& work) {
    if (work.linked_model == work.scene->model) return set_linked(work, std::nullopt);
    Result<Drawable> now = make_drawable(*work.scene);
    work.linked_model = work.scene->model;
    work.is_current = static_cast<bool>(now);
    const std::string problem = now ? std::string() : now.error();
    if (now) work.drawable = std::make_shared<const Drawable>(*std::move(now));
    set_linked(work, SceneState{work.preview, work.scene->version, problem});
    wake_();
  }

  void set_linked(const Work& work, std::optional<SceneState> state) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = slots_.find(work.preview);
      if (found == slots_.end() || found->second.serial != work.serial) return;
      Slot& slot = found->second;
      slot.good = work.drawable;
      slot.is_current = work.is_current;
      slot.linked_model = work.linked_model;
      slot.linked = work.serial;
      if (state) slot.state = std::move(state);
    }
    work_.notify_all();
  }

  std::optional<Frame> draw_on_cpu(const Work& work, render::SphereCache& cache) {
    if (!work.drawable) return std::nullopt;
    if (!work.scene->object.is_plain()) {
      return draw_object(work, Device::Cpu, objects_on_cpu_, evaluator_on_cpu(work.drawable->cpu));
    }
    render::SphereView view = work.scene->view;
    view.size = std::min(view.size, work.max_size);
    const Clock::time_point begin = Clock::now();
    const auto picture = preview::draw_on_cpu(work.drawable->cpu, view, cache, [&] { return is_wanted(work, begin); });
    if (!picture) return std::nullopt;
    tell_of_files(work, {});
    return make_frame(work, Device::Cpu, *picture);
  }

  std::optional<Frame> draw_object(const Work& work, Device device, ObjectPainter& painter,
                                   const TableEvaluator& evaluate) {
    render::SphereView view = work.scene->view;
    view.size = std::min(view.size, device == Device::Cpu ? work.max_size : kMaxCpuSize);
    const Clock::time_point begin = Clock::now();
    const ObjectPainter::Outcome outcome = painter.draw({work.preview, work.serial, work.scene->object, view}, evaluate,
                                                        [&] { return is_wanted(work, begin); });
    if (const auto* fault = std::get_if<render::RenderFault>(&outcome)) note_render_fault(*fault);
    if (const auto* failure = std::get_if<Failure>(&outcome)) tell_of_files(work, failure->message);
    const auto* const drawn = std::get_if<ObjectPainter::Drawn>(&outcome);
    if (drawn == nullptr) return std::nullopt;
    tell_of_files(work, {});
    Frame frame = make_frame(work, device, drawn->picture);
    frame.samples = drawn->samples;
    frame.all_samples = drawn->all_samples;
    return frame;
  }

  /// What is wrong with the files of an object, or that nothing is any more.
  void tell_of_files(const Work& work, const std::string& problem) {
    const std::lock_guard lock(mutex_);
    const auto found = slots_.find(work.preview);
    if (found == slots_.end() || found->second.serial != work.serial) return;
    if (problem.empty() && (!found->second.lacks_files || !work.is_current)) return;
    found->second.lacks_files = !problem.empty();
    found->second.state = SceneState{work.preview, work.scene->version, problem};
  }

  bool is_wanted(const Work& work, Clock::time_point begin) {
    const std::lock_guard lock(mutex_);
    if (is_ending_ || !slots_.contains(work.preview)) return false;
    const auto waits = [&](const auto& entry) {
      const bool is_other = entry.first != work.preview || entry.second.serial != work.serial;
      return is_other && entry.second.drawn_on_cpu < entry.second.serial;
    };
    return Clock::now() - begin < kLongest || std::ranges::none_of(slots_, waits);
  }

  void run_gpu() {
    while (std::optional<Work> work = wait_for_work([this] { return next_for_gpu(); })) {
      try {
        give_head_start_to_cpu(*work);
        deposit(*work, Device::Gpu, draw_on_gpu(*work));
      } catch (const std::exception& fault) {
        give_up(*work, Device::Gpu, fault);
      }
    }
  }

  /// After a fault of ours: the scene has no picture of the device, and all others go on.
  void give_up(const Work& work, Device device, const std::exception& fault) {
    note_fault(fmt::format("a picture was given up: {}", fault.what()));
    deposit(work, device, std::nullopt);
  }

  void tell_fault(Work work) {
    work.is_current = false;
    work.linked_model.reset();
    set_linked(work, SceneState{work.preview, work.scene->version, "an internal error: there is no new picture"});
    wake_();
  }

  /// A renderer in software would take the cores from the picture that comes first.
  void give_head_start_to_cpu(const Work& work) {
    std::unique_lock lock(mutex_);
    work_.wait_for(lock, kHeadStart, [&] {
      const auto slot = slots_.find(work.preview);
      return is_ending_ || slot == slots_.end() || slot->second.drawn_on_cpu >= work.serial;
    });
  }

  std::optional<Frame> draw_on_gpu(const Work& work) {
    const Result<const render::ShaderModel*> model = emitted_.of({work.drawable, &work.drawable->program});
    if (!model) {
      note_fault(model.error());
      return std::nullopt;
    }
    if (!work.scene->object.is_plain()) {
      return draw_object(work, Device::Gpu, objects_on_gpu_, evaluator_on_gpu(worker_, **model));
    }
    const auto drawn = worker_.draw(**model, work.scene->view);
    if (const auto* fault = std::get_if<render::RenderFault>(&drawn)) {
      note_render_fault(*fault);
      return std::nullopt;
    }
    return make_frame(work, Device::Gpu, std::get<render::GpuPicture>(drawn).picture);
  }

  void note_render_fault(const render::RenderFault& fault) {
    note_fault(fault.message);
    if (fault.kind == render::RenderFaultKind::NoRenderer) give_up_gpu();
  }

  void note_fault(std::string message) {
    const std::lock_guard lock(mutex_);
    faults_.push_back(std::move(message));
  }

  /// The scenes are drawn once more on the CPU, at their full size.
  void give_up_gpu() {
    const std::lock_guard lock(mutex_);
    has_no_gpu_ = true;
    for (auto& [preview, slot] : slots_) slot.drawn_on_cpu = 0;
    work_.notify_all();
  }

  /// A frame that is older than what the client is to get is left out.
  void deposit(const Work& work, Device device, std::optional<Frame> frame) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = slots_.find(work.preview);
      if (found == slots_.end()) return;
      note_drawn(work, device, found->second);
      const bool more = frame && frame->samples < frame->all_samples;
      if (device == Device::Gpu) found->second.more_on_gpu = more;
      if (device == Device::Cpu) found->second.more_on_cpu = more && has_no_gpu_;
      const std::pair age(work.serial, device);
      if (frame && age >= found->second.newest) {
        found->second.newest = age;
        found->second.ready = std::move(frame);
      }
    }
    wake_();
    work_.notify_all();
  }

  /// A picture that was begun before the GPU was given up is not the last one of the CPU.
  void note_drawn(const Work& work, Device device, Slot& slot) const {
    if (device == Device::Cpu && has_no_gpu_ && work.max_size < kMaxCpuSize) return;
    uint64_t& drawn = device == Device::Cpu ? slot.drawn_on_cpu : slot.drawn_on_gpu;
    drawn = std::max(drawn, work.serial);
  }

  std::function<void()> wake_;
  // Of the CPU's thread.
  ObjectPainter objects_on_cpu_;
  // Of the GPU's thread.
  ObjectPainter objects_on_gpu_;
  render::RenderWorker worker_;
  RecentShaderModels emitted_;

  std::mutex mutex_;
  std::condition_variable work_;
  std::map<int64_t, Slot> slots_;
  std::vector<std::string> faults_;
  uint64_t last_serial_ = 0;
  uint64_t last_turn_ = 0;
  bool is_ending_ = false;
  bool has_no_gpu_ = false;
  std::thread cpu_;
  std::thread gpu_;
};

PreviewService::PreviewService(std::function<void()> wake, render::WorkerOptions options)
    : painter_(std::make_unique<Painter>(std::move(wake), std::move(options))) {}
PreviewService::~PreviewService() = default;

void PreviewService::show(int64_t preview, Scene scene) {
  painter_->show(preview, std::move(scene));
}
void PreviewService::acknowledge(int64_t preview) {
  painter_->acknowledge(preview);
}
void PreviewService::close(int64_t preview) {
  painter_->close(preview);
}
std::vector<Event> PreviewService::take_events() {
  return painter_->take_events();
}
std::vector<std::string> PreviewService::take_faults() {
  return painter_->take_faults();
}

}  // namespace texbrdf::preview

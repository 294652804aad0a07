#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "cli/check_scene.h"
#include "cli/messages.h"
#include "cli/subcommands.h"
#include "files/file_source.h"
#include "render/gl.h"
#include "render/glsl_check.h"
#include "render/scene_screen.h"
#include "render/scene_tracer.h"
#include "scene/scene_shader.h"
#include "viewing/live_scene.h"
#include "viewing/viewer.h"
#include "window/window.h"

namespace texbrdf::cli {
namespace {

struct ViewOptions {
  std::string path;
  uint32_t size = 640;
  std::string view_name = "shaded";
};

constexpr uint32_t kMaxWindowSize = 4096;
/// Seconds of rest after which files are looked at again, and a picture with fewer pixels is drawn whole.
constexpr double kRest = 0.1;

/// What can be drawn: a scene and its shader.
struct Drawable {
  viewing::Viewer viewer;
  scene::SceneShader shader;
};

render::SceneState state_of(const scene::Scene& scene) {
  return {scene.camera, scene.lights, scene.environment, scene.settings, scene::scene_frames(scene)};
}

/// Prints what a compiler of GLSL says, as a mistake of the scene's code where it is one.
std::string tell_fault(const std::string& message, const scene::SceneShader& shader) {
  const auto mistake = mistake_in_code(shader, message);
  if (mistake) fmt::print(stderr, "{}\n", *mistake);
  if (!mistake) print_message(message);
  return mistake.value_or(message);
}

void print_problems(const scene_json::LoadedScene& loaded) {
  const std::string here = files::real_path(".");
  for (const scene_json::Problem& problem : loaded.problems) fmt::print(stderr, "{}\n", describe(problem, here));
}

/// A window, the scene in it, and what the person does there.
class SceneWindow {
 public:
  SceneWindow(viewing::LiveScene files, Drawable drawable, window::Window window, const render::Gl& gl)
      : files_(std::move(files)), drawable_(std::move(drawable)), window_(std::move(window)), gl_(gl) {}

  ExitCode run() {
    Result<render::SceneTracer> tracer = render::SceneTracer::create(gl_, checker_);
    if (!tracer) return fail(tracer.error(), ExitCode::NoRenderer);
    if (const auto ready = tracer->prepare(drawable_.shader.source, look().effects()); !ready) {
      tell_fault(ready.error(), drawable_.shader);
      return ExitCode::DocumentHasErrors;
    }
    render::SceneScreen screen(gl_, *tracer);
    bool is_due = true;
    bool is_moving = false;
    bool is_holding = false;  // a key
    while (!drawable_.viewer.wants_to_close()) {
      if (is_due) {
        const auto drawn = draw(screen, is_moving);
        if (!drawn) return fail(drawn.error(), ExitCode::NoRenderer);
        is_whole_ = *drawn;
      }
      const window::Events events = window_.take_events(is_moving && (is_whole_ || is_holding) ? 0 : kRest);
      if (events.wants_to_close) break;
      is_holding = !events.held.empty();
      is_moving = drawable_.viewer.apply(input_of(events));
      const bool is_read_anew = reload(*tracer);
      is_due = is_moving || is_read_anew || events.is_stale || !is_whole_;
    }
    return ExitCode::Fine;
  }

 private:
  static ExitCode fail(const std::string& message, ExitCode code) {
    print_message(message);
    return code;
  }

  static viewing::Input input_of(const window::Events& events) {
    return {events.held, events.seconds, events.pressed, events.drag_right, events.drag_down, events.wheel};
  }

  render::SceneLook look() const {
    render::SceneLook look;
    look.view = render::scene_view_entries()[drawable_.viewer.view()].view;
    return look;
  }

  std::string title() const {
    const std::string& name = drawable_.viewer.scene().name;
    std::string title = name.empty() ? std::string("texbrdf") : name;
    if (drawable_.viewer.view() != 0)
      title += fmt::format(" ({})", render::scene_view_entries()[drawable_.viewer.view()].word);
    return problem_.empty() ? title : fmt::format("{} - not up to date: {}", title, problem_);
  }

  /// Whether there is something new to draw. What cannot be drawn leaves the last picture.
  bool reload(render::SceneTracer& tracer) {
    std::optional<scene_json::LoadedScene> loaded = files_.read_changed();
    if (!loaded) return false;
    print_problems(*loaded);
    if (!loaded->scene) {
      problem_ = loaded->problems.empty() ? "it cannot be read" : describe(loaded->problems.front());
      window_.set_title(title());
      return false;
    }
    scene::SceneShader shader = make_scene_shader(*loaded->scene);
    if (const auto prepared = tracer.prepare(shader.source, look().effects()); !prepared) {
      problem_ = tell_fault(prepared.error(), shader);
      window_.set_title(title());
      return false;
    }
    problem_.clear();
    drawable_.shader = std::move(shader);
    drawable_.viewer.reload(*std::move(loaded->scene));
    return true;
  }

  /// Whether it was drawn with all pixels.
  Result<bool> draw(render::SceneScreen& screen, bool is_moving) {
    window_.set_title(title());
    const auto [width, height] = window_.size();
    if (width == 0 || height == 0) return true;
    const auto drawn = screen.draw(drawable_.shader.source, state_of(drawable_.viewer.scene()), look(), width, height,
                                   render::SceneDisplay{}, is_moving);
    if (!drawn) return Failure{drawn.error()};
    window_.swap();
    return drawn->is_whole;
  }

  viewing::LiveScene files_;
  Drawable drawable_;
  window::Window window_;
  const render::Gl& gl_;
  render::GlslChecker checker_;
  std::string problem_;   ///< of the files as they are now
  bool is_whole_ = true;  ///< the picture in the window
};

ExitCode view(const ViewOptions& options) {
  if (!is_scene_file(options.path)) {
    print_message(fmt::format("{}: a scene or a part of one is a .json file", options.path));
    return ExitCode::BadUsage;
  }
  const std::string path = files::real_path(options.path);
  files::DiskFiles disk;
  if (path.empty() || !disk.text(path)) {
    print_message(fmt::format("{}: cannot be read", options.path));
    return ExitCode::BadUsage;
  }
  viewing::LiveScene files(path, disk);
  std::optional<scene_json::LoadedScene> loaded = files.read_changed();
  print_problems(*loaded);
  if (!loaded->scene) return ExitCode::DocumentHasErrors;
  Drawable drawable{viewing::Viewer(*loaded->scene), make_scene_shader(*loaded->scene)};
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) {
    if (entry.word == options.view_name) drawable.viewer.show_view(static_cast<uint32_t>(entry.view));
  }

  Result<window::Window> window = window::Window::open("texbrdf", {options.size, options.size});
  const Result<render::Gl> gl =
      window ? render::load_gl([&](const char* name) { return window->gl_function(name); }) : Failure{window.error()};
  if (!gl) {
    print_message(gl.error());
    print_message("`texbrdf render` draws without a window");
    return ExitCode::NoRenderer;
  }
  return SceneWindow(std::move(files), std::move(drawable), *std::move(window), *gl).run();
}

}  // namespace

Subcommand add_view(CLI::App& program) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* const arguments = program.add_subcommand("view", "Look around in a scene, in a window");
  arguments->add_option("SCENE", options->path, "a scene, a model, a material, a shader or a primitive")->required();
  arguments->add_option("--size", options->size, "width and height of the window, in pixels")
      ->check(CLI::Range(16U, kMaxWindowSize))
      ->capture_default_str();
  std::vector<std::string> views;
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) views.emplace_back(entry.word);
  arguments->add_option("--view", options->view_name, "what is shown first")
      ->check(CLI::IsMember(views))
      ->capture_default_str();
  return {arguments, [options] { return view(*options); }};
}

}  // namespace texbrdf::cli

#include "cli/render_scene.h"

#include <fmt/core.h>

#include <chrono>
#include <map>
#include <utility>
#include <variant>

#include "cli/check_scene.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/render_fault.h"
#include "cli/sample_progress.h"
#include "render/png.h"
#include "render/scene_picture.h"
#include "scene/scene_shader.h"

namespace texbrdf::cli {
namespace {

/// Of one strip of the picture, or of compiling.
constexpr std::chrono::seconds kDeadline{60};

render::SceneJob scene_job(const scene::Scene& scene, const std::string& source, const SceneOptions& options,
                           PictureSize size) {
  scene::RenderSettings settings = scene.settings;
  settings.max_steps = options.max_steps.value_or(settings.max_steps);
  settings.max_distance = options.max_distance.value_or(settings.max_distance);
  settings.surface_threshold = options.surface_threshold.value_or(settings.surface_threshold);
  return {.source = source,
          .state = {scene.camera, scene.lights, scene.environment, settings, scene_frames(scene)},
          .look = options.look,
          .width = size.width,
          .height = size.height,
          .samples = options.samples};
}

ExitCode report(const render::RenderFault& fault, const scene::SceneShader& shader) {
  const auto mistake =
      fault.kind == render::RenderFaultKind::Shader ? mistake_in_code(shader, fault.message) : std::nullopt;
  if (!mistake) return report_render_fault(fault, "");
  fmt::print(stderr, "{}\n", *mistake);
  return ExitCode::DocumentHasErrors;
}

using PictureOrFault = std::variant<render::ScenePicture, render::RenderFault>;

PictureOrFault draw(const render::SceneJob& job) {
  render::WorkerOptions worker_options;
  worker_options.deadline = kDeadline;
  render::RenderWorker worker(std::move(worker_options));
  SampleProgress progress(job.samples);
  return draw_scene(worker, job, [&](uint64_t done, uint64_t all) {
    progress.show_part(static_cast<double>(done) / static_cast<double>(all));
    return true;
  });
}

}  // namespace

void add_scene_options(CLI::App& arguments, SceneOptions& options) {
  const std::map<std::string, render::Shadows> shadows{
      {"none", render::Shadows::None}, {"hard", render::Shadows::Hard}, {"soft", render::Shadows::Soft}};
  const auto add = [&](const char* name, auto& value, const char* text) {
    return arguments.add_option(name, value, text)->group(kSceneGroup);
  };
  add("--shadows", options.look.shadows, "of lit materials: none, hard (the default) or soft")
      ->transform(CLI::CheckedTransformer(shadows).description(""))
      ->type_name("SHADOWS");
  add("--light-size", options.look.light_size, "degrees under which lights appear, for soft shadows")
      ->capture_default_str();
  arguments.add_flag("--occlusion", options.look.occlusion, "less ambient light where surfaces are near")
      ->group(kSceneGroup);
  add("--occlusion-radius", options.look.occlusion_radius, "units that are near")->capture_default_str();
  add("--max-steps", options.max_steps, "of a ray, in the place of the scene's");
  add("--max-distance", options.max_distance, "where a ray ends, in the place of the scene's");
  add("--surface-threshold", options.surface_threshold, "how near is met, in the place of the scene's");
}

ExitCode render_scene(const std::string& path, const SceneOptions& options, PictureSize size,
                      const render::SceneDisplay& display, const std::string& output) {
  const CheckedScene checked = check_scene(path);
  fmt::print(stderr, "{}", checked.report);
  if (!checked.scene) return checked.exit_code;
  if (const auto fault = render::find_fault(display)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  const scene::SceneShader shader = make_scene_shader(*checked.scene);
  const PictureOrFault drawn = draw(scene_job(*checked.scene, shader.source, options, size));
  if (const auto* fault = std::get_if<render::RenderFault>(&drawn)) return report(*fault, shader);
  const render::Picture picture = std::get<render::ScenePicture>(drawn).picture(options.look.view, display);
  const std::vector<uint8_t> png = encode_png(picture.image, render::PngEffort::Small);
  if (const auto failure = write_output(output, {reinterpret_cast<const char*>(png.data()), png.size()})) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  if (picture.bad_pixels.total() > 0) print_message(render::describe(picture.bad_pixels));
  return checked.exit_code;
}

}  // namespace texbrdf::cli

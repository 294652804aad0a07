#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string_view>

#include "cli/check_scene.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/object_options.h"
#include "cli/picture_size.h"
#include "cli/render_fault.h"
#include "cli/render_scene.h"
#include "cli/sample_progress.h"
#include "cli/subcommands.h"
#include "preview/cpu_frame.h"
#include "preview/object_picture.h"
#include "preview/shader_model.h"
#include "render/png.h"
#include "render/worker_client.h"

namespace texbrdf::cli {
namespace {

enum class Device : uint8_t { Gpu, Cpu };

struct RenderOptions {
  ModelOptions model;
  std::string output;
  Device device = Device::Gpu;
  std::string view_name;
  std::string size;
  std::optional<uint32_t> samples;
  render::SphereView view;
  SceneOptions scene;
  ObjectOptions object;
};

using PictureOrExit = std::variant<render::Picture, ExitCode>;

/// A picture is worth more patience on the command line than in an editor.
constexpr std::chrono::seconds kDeadline{60};
/// Between two reports of how far a picture is.
constexpr uint32_t kSamplesAtOnce = 8;

/// The model of a device, or the exit code after telling why there is none.
template <typename T>
std::variant<T, ExitCode> or_exit(Result<T> model) {
  if (model) return *std::move(model);
  print_message(model.error());
  return ExitCode::DocumentHasErrors;
}

render::RenderWorker make_worker() {
  render::WorkerOptions options;
  options.deadline = kDeadline;
  return render::RenderWorker(std::move(options));
}

PictureOrExit draw_on_cpu(const ir::Program& program, const render::SphereView& view) {
  const auto model = or_exit(preview::cpu_model(program));
  if (const auto* failed = std::get_if<ExitCode>(&model)) return *failed;
  render::SphereCache cache;
  return preview::draw_on_cpu(std::get<preview::CpuModel>(model), view, cache);
}

PictureOrExit draw_on_gpu(const ir::Program& program, const render::SphereView& view) {
  const auto model = or_exit(preview::shader_model(program));
  if (const auto* failed = std::get_if<ExitCode>(&model)) return *failed;
  render::RenderWorker worker = make_worker();
  auto drawn = worker.draw(std::get<render::ShaderModel>(model), view);
  if (const auto* fault = std::get_if<render::RenderFault>(&drawn)) {
    return report_render_fault(*fault);
  }
  return std::get<render::GpuPicture>(std::move(drawn)).picture;
}

/// An object, or the sphere in the light of an environment.
PictureOrExit draw_object(preview::ObjectScene scene, uint32_t samples, const preview::TableEvaluator& evaluate) {
  preview::ObjectPicture picture(std::move(scene));
  SampleProgress progress(picture.is_exact() ? 0 : samples);
  while (picture.samples() < samples) {
    const uint32_t count = std::min(kSamplesAtOnce, samples - picture.samples());
    if (const auto fault = picture.add(count, evaluate, [] { return true; })) return report_render_fault(*fault);
    if (picture.is_exact()) break;
    progress.show(picture.samples());
  }
  return picture.picture();
}

PictureOrExit draw_object(const RenderOptions& options, const ir::Program& program) {
  auto scene = object_scene(options.object, options.view);
  if (const auto* failed = std::get_if<ExitCode>(&scene)) return *failed;
  const auto draw = [&](const preview::TableEvaluator& evaluate) {
    return draw_object(std::get<preview::ObjectScene>(std::move(scene)), options.object.samples, evaluate);
  };
  if (options.device == Device::Cpu) {
    const auto model = or_exit(preview::cpu_model(program));
    if (const auto* failed = std::get_if<ExitCode>(&model)) return *failed;
    return draw(preview::evaluator_on_cpu(std::get<preview::CpuModel>(model)));
  }
  const auto model = or_exit(preview::shader_model(program));
  if (const auto* failed = std::get_if<ExitCode>(&model)) return *failed;
  render::RenderWorker worker = make_worker();
  return draw(preview::evaluator_on_gpu(worker, std::get<render::ShaderModel>(model)));
}

PictureOrExit draw(const RenderOptions& options, const ir::Program& program) {
  if (!is_plain_sphere(options.object)) return draw_object(options, program);
  return options.device == Device::Gpu ? draw_on_gpu(program, options.view) : draw_on_cpu(program, options.view);
}

ExitCode bad_usage(std::string_view message) {
  print_message(message);
  return ExitCode::BadUsage;
}

/// Options for documents and for scenes stand side by side; one that does not fit the file is a mistake.
constexpr std::array kOptionsOfBoth{"FILE",   "--output",  "--device", "--view",
                                    "--size", "--samples", "--gamma",  "--exposure"};

std::optional<std::string> misplaced_option(const CLI::App& arguments, bool is_scene) {
  for (const CLI::Option* option : arguments.get_options()) {
    const std::string name = option->get_lnames().empty() ? "FILE" : "--" + option->get_lnames().front();
    const bool is_of_both = std::ranges::find(kOptionsOfBoth, name) != kOptionsOfBoth.end();
    if (option->count() == 0 || is_of_both || (option->get_group() == kSceneGroup) == is_scene) continue;
    return fmt::format("{} is for {}, and the file is a {}", name, is_scene ? "documents" : "scenes",
                       is_scene ? "scene" : "document");
  }
  return std::nullopt;
}

ExitCode render_scene(const CLI::App& arguments, RenderOptions& options) {
  if (options.device == Device::Cpu) return bad_usage("scenes are drawn with --device gpu only");
  if (options.view_name == "sphere") return bad_usage("--view sphere is for documents, and the file is a scene");
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) {
    if (options.view_name == entry.word) options.scene.look.view = entry.view;
  }
  PictureSize size{512, 512};
  if (!options.size.empty()) {
    const auto typed = read_picture_size(options.size);
    if (!typed) return bad_usage(fmt::format("--size takes WIDTHxHEIGHT, got '{}'", options.size));
    size = *typed;
  }
  options.scene.samples = options.samples.value_or(options.scene.samples);
  render::SceneDisplay display;
  if (arguments.count("--gamma") > 0) display.gamma = options.view.gamma;
  if (arguments.count("--exposure") > 0) display.exposure = options.view.exposure;
  return render_scene(options.model.file, options.scene, size, display, options.output);
}

/// A document's picture is square.
std::optional<std::string> read_document_options(RenderOptions& options) {
  if (!options.view_name.empty() && options.view_name != "sphere") {
    return fmt::format("--view {} is for scenes, and the file is a document", options.view_name);
  }
  options.object.samples = options.samples.value_or(options.object.samples);
  if (options.size.empty()) return std::nullopt;
  const auto size = read_picture_size(options.size);
  if (!size || size->width != size->height) {
    return fmt::format("--size takes a width, which is the height too, got '{}'", options.size);
  }
  options.view.size = size->width;
  return std::nullopt;
}

ExitCode render_document(const RenderOptions& options) {
  if (const auto fault = render::find_fault(options.view)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  const auto loaded = load_model(options.model);
  if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
  const Model& model = std::get<Model>(loaded);

  const PictureOrExit drawn = draw(options, model.program);
  if (const auto* failed = std::get_if<ExitCode>(&drawn)) return *failed;
  const render::Picture& picture = std::get<render::Picture>(drawn);

  const std::vector<uint8_t> png = render::encode_png(picture.image, render::PngEffort::Small);
  if (const auto failure = write_output(options.output, {reinterpret_cast<const char*>(png.data()), png.size()})) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  if (picture.bad_pixels.total() > 0) print_message(render::describe(picture.bad_pixels));
  return model.exit_code();
}

ExitCode render(const CLI::App& arguments, RenderOptions& options) {
  const bool is_scene = is_scene_file(options.model.file);
  if (const auto fault = misplaced_option(arguments, is_scene)) return bad_usage(*fault);
  if (is_scene) return render_scene(arguments, options);
  if (const auto fault = read_document_options(options)) return bad_usage(*fault);
  return render_document(options);
}

std::string view_help() {
  std::string help = "what to draw: sphere (of a document); of a scene";
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) {
    help += fmt::format("\n{}: {}", entry.word, entry.meaning);
  }
  return help;
}

std::vector<std::string> view_names() {
  std::vector<std::string> names{"sphere"};
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) names.emplace_back(entry.word);
  return names;
}

}  // namespace

Subcommand add_render(CLI::App& program) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* const arguments =
      program.add_subcommand("render", "Draw a lit sphere or another object made of the BRDF, or a scene (.json)");
  add_model_options(*arguments, options->model);
  arguments->get_option("FILE")->description("a LaTeX document, - for standard input, or a scene (.json)");
  arguments->add_option("-o,--output", options->output, "the PNG file to write, - for standard output")
      ->type_name("OUT.png")
      ->required();
  const std::map<std::string, Device> devices{{"gpu", Device::Gpu}, {"cpu", Device::Cpu}};
  arguments->add_option("--device", options->device, "gpu (through EGL) or cpu")
      ->transform(CLI::CheckedTransformer(devices).description(""))
      ->type_name("DEVICE");
  arguments->add_option("--view", options->view_name, view_help())
      ->check(CLI::IsMember(view_names()).description(""))
      ->type_name("VIEW");
  render::SphereView& view = options->view;
  arguments->add_option("--size", options->size, "pixels (256); of a scene WIDTHxHEIGHT or one number (512)")
      ->type_name("SIZE");
  arguments->add_option("--samples", options->samples, "of each pixel (1), or light directions in --light (256)");
  arguments->add_option("--theta", view.theta, "degrees between light and view axis")->capture_default_str();
  arguments->add_option("--phi", view.phi, "degrees of the light around the view axis")->capture_default_str();
  arguments->add_option("--gamma", view.gamma, "display gamma (of a scene 2.2)")->capture_default_str();
  arguments->add_option("--exposure", view.exposure, "stops (of a scene 0)")->capture_default_str();
  add_object_options(*arguments, options->object);
  add_scene_options(*arguments, options->scene);
  return {arguments, [arguments, options] { return render(*arguments, *options); }};
}

}  // namespace texbrdf::cli

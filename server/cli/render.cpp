#include <fmt/core.h>

#include <chrono>
#include <memory>
#include <optional>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/render_fault.h"
#include "cli/subcommands.h"
#include "preview/cpu_frame.h"
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
  std::string view_name = "sphere";
  render::SphereView view;
};

using PictureOrExit = std::variant<render::Picture, ExitCode>;

/// A picture is worth more patience on the command line than in an editor.
constexpr std::chrono::seconds kDeadline{60};

PictureOrExit draw_on_cpu(const ir::Program& program, const render::SphereView& view) {
  const Result<preview::CpuModel> model = preview::cpu_model(program);
  if (!model) {
    print_message(model.error());
    return ExitCode::DocumentHasErrors;
  }
  render::SphereCache cache;
  return preview::draw_on_cpu(*model, view, cache);
}

PictureOrExit draw_on_gpu(const ir::Program& program, const render::SphereView& view) {
  const Result<render::ShaderModel> model = preview::shader_model(program);
  if (!model) {
    print_message(model.error());
    return ExitCode::DocumentHasErrors;
  }
  render::WorkerOptions worker_options;
  worker_options.deadline = kDeadline;
  render::RenderWorker worker(std::move(worker_options));
  auto drawn = worker.draw(*model, view);
  if (const auto* fault = std::get_if<render::RenderFault>(&drawn)) {
    return report_render_fault(*fault);
  }
  return std::get<render::GpuPicture>(std::move(drawn)).picture;
}

ExitCode render(const RenderOptions& options) {
  if (const auto fault = render::find_fault(options.view)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  const auto loaded = load_model(options.model);
  if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
  const Model& model = std::get<Model>(loaded);

  const PictureOrExit drawn = options.device == Device::Gpu ? draw_on_gpu(model.program, options.view)
                                                            : draw_on_cpu(model.program, options.view);
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

}  // namespace

Subcommand add_render(CLI::App& program) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* const arguments = program.add_subcommand("render", "Draw a lit sphere made of the BRDF");
  add_model_options(*arguments, options->model);
  arguments->add_option("-o,--output", options->output, "the PNG file to write, - for standard output")
      ->type_name("OUT.png")
      ->required();
  const std::map<std::string, Device> devices{{"gpu", Device::Gpu}, {"cpu", Device::Cpu}};
  arguments->add_option("--device", options->device, "gpu (through EGL) or cpu")
      ->transform(CLI::CheckedTransformer(devices).description(""))
      ->type_name("DEVICE");
  arguments->add_option("--view", options->view_name, "what to draw: sphere")->check(CLI::IsMember({"sphere"}));
  render::SphereView& view = options->view;
  arguments->add_option("--size", view.size, "width and height in pixels")->capture_default_str();
  arguments->add_option("--theta", view.theta, "degrees between light and view axis")->capture_default_str();
  arguments->add_option("--phi", view.phi, "degrees of the light around the view axis")->capture_default_str();
  arguments->add_option("--gamma", view.gamma, "display gamma")->capture_default_str();
  arguments->add_option("--exposure", view.exposure, "stops")->capture_default_str();
  return {arguments, [options] { return render(*options); }};
}

}  // namespace texbrdf::cli

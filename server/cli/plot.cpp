#include "plots/plot.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <memory>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/subcommands.h"
#include "plots/csv.h"
#include "plots/raster.h"
#include "plots/svg.h"
#include "render/png.h"

namespace texbrdf::cli {
namespace {

/// Of the evaluator, for all series together: some ten seconds.
constexpr uint64_t kMostSteps = 1'000'000'000;
constexpr int kRefinements = 6;

struct PlotOptions {
  ModelOptions model;
  std::vector<std::string> files;
  plots::Request request;
  plots::Look look;
  bool is_log = false;
  std::string output;
};

enum class Format : uint8_t { Unknown, Svg, Png, Csv };

Format format_of(std::string_view path) {
  if (path.ends_with(".svg")) return Format::Svg;
  if (path.ends_with(".png")) return Format::Png;
  if (path.ends_with(".csv")) return Format::Csv;
  return Format::Unknown;
}

std::string written(const plots::Plot& plot, Format format) {
  if (format == Format::Csv) return plots::write_csv(plot);
  const plots::Drawing drawing = plots::draw(plot);
  if (format == Format::Svg) return plots::write_svg(drawing);
  const std::vector<uint8_t> png = render::encode_png(plots::rasterise(drawing), render::PngEffort::Small);
  return {png.begin(), png.end()};
}

std::optional<std::string> usage_fault(const PlotOptions& options) {
  if (auto fault = plots::find_fault(options.request)) return fault;
  if (auto fault = plots::find_fault(options.look)) return fault;
  if (format_of(options.output) == Format::Unknown) {
    return fmt::format("--output has to end with .svg, .png or .csv, got '{}'", options.output);
  }
  return std::nullopt;
}

std::string label_of(const PlotOptions& options, const std::string& file) {
  return options.files.size() == 1 ? "" : std::filesystem::path(input_name(file)).stem().string();
}

ExitCode plot(const PlotOptions& options) {
  if (const auto fault = usage_fault(options)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  plots::Plot plot{.request = options.request, .look = options.look, .title = {}, .series = {}};
  if (options.is_log) plot.look.scale = plots::ScaleKind::Log;
  if (options.files.size() == 1) plot.title = std::filesystem::path(input_name(options.files[0])).stem().string();
  ExitCode status = ExitCode::Fine;
  for (const std::string& file : options.files) {
    ModelOptions one = options.model;
    one.file = file;
    auto loaded = load_model(one);
    if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
    Model& model = std::get<Model>(loaded);
    if (model.document_has_errors) status = ExitCode::DocumentHasErrors;
    const auto exact = preview::ExactModel::compile(std::move(model.program));
    if (!exact) {
      print_message(fmt::format("{}: {}", input_name(file), exact.error()));
      return ExitCode::DocumentHasErrors;
    }
    auto series = plots::sample(*exact, label_of(options, file), options.request,
                                {.steps = kMostSteps / options.files.size(), .refinements = kRefinements});
    if (!series) {
      print_message(fmt::format("{}: {}", input_name(file), series.error()));
      return ExitCode::DocumentHasErrors;
    }
    plot.series.push_back(*std::move(series));
  }
  if (const auto failure = write_output(options.output, written(plot, format_of(options.output)))) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  for (const std::string& note : plots::notes_of(plot)) print_message(note);
  return status;
}

}  // namespace

Subcommand add_plot(CLI::App& program) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* const arguments = program.add_subcommand("plot", "Draw curves of the BRDF");
  arguments->add_option("FILE", options->files, "LaTeX documents, - for standard input")->required();
  add_root_option(*arguments, options->model.root);
  arguments->add_option("--set", options->model.settings, "another value for a parameter: m=0.2, \\rho_d=0.1,0.2,0.3")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  std::map<std::string, plots::View> views;
#define VIEW(name, word, description) views[word] = plots::View::name;
#include "plots/views.def"
#undef VIEW
  arguments
      ->add_option("--view", options->request.view,
                   "what to plot: lobe, polar, theta-o, theta-h, theta-d, albedo, slice")
      ->transform(CLI::CheckedTransformer(views).description(""))
      ->type_name("VIEW")
      ->required();
  arguments->add_option("-o,--output", options->output, "the file to write, by its ending: .svg, .png, .csv")
      ->type_name("OUT")
      ->required();
  const std::map<std::string, plots::Channels> channels{{"r", plots::Channels::Red},
                                                        {"g", plots::Channels::Green},
                                                        {"b", plots::Channels::Blue},
                                                        {"all", plots::Channels::All},
                                                        {"luminance", plots::Channels::Luminance}};
  arguments->add_option("--channel", options->look.channels, "r, g, b, all, luminance")
      ->transform(CLI::CheckedTransformer(channels).description(""))
      ->type_name("CHANNEL");
  arguments->add_flag("--log", options->is_log, "a logarithmic axis");
  arguments->add_flag("--cosine", options->request.times_cosine, "times the cosine of the viewer, or of the light");
  arguments->add_option("--incidence", options->request.incidence, "degrees of the light from the normal")
      ->capture_default_str();
  arguments->add_option("--phi", options->request.phi, "degrees of the light around the normal")->capture_default_str();
  arguments->add_option("--theta-h", options->request.theta_h, "degrees of the half vector, for theta-d")
      ->capture_default_str();
  arguments->add_option("--theta-d", options->request.theta_d, "degrees of the difference, for theta-h")
      ->capture_default_str();
  arguments->add_option("--phi-d", options->request.phi_d, "degrees of the light around the half vector")
      ->capture_default_str();
  arguments->add_option("--max", options->look.maximum, "the end of the axis of values");
  arguments->add_option("--width", options->look.width, "pixels")->capture_default_str();
  arguments->add_option("--height", options->look.height, "pixels")->capture_default_str();
  return {arguments, [options] { return plot(*options); }};
}

}  // namespace texbrdf::cli

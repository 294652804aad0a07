#include "plots/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/picture_size.h"
#include "cli/subcommands.h"
#include "plots/csv.h"
#include "plots/raster.h"
#include "plots/svg.h"
#include "render/png.h"
#include "semantics/names.h"

namespace texbrdf::cli {
namespace {

/// Of the evaluator, for all series together: some twenty seconds.
constexpr uint64_t kMostSteps = 1'000'000'000;
constexpr int kRefinements = 6;
/// More cannot be told apart.
constexpr std::size_t kMostSeries = 32;

struct PlotOptions {
  ModelOptions model;  ///< its file is each of `files` in turn
  std::vector<std::string> files;
  std::string variation;  ///< NAME=A,B,C, as typed; empty: none
  plots::Request request;
  plots::Look look;
  std::string size;
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

/// A parameter and the values that are held against each other.
struct Variation {
  std::string typed_name;
  std::string name;  ///< canonical
  std::vector<std::vector<double>> values;
  std::vector<std::string> typed_values;
};

Failure bad_variation(std::string_view typed) {
  return {fmt::format(
      "--vary takes NAME=A,B,C or, of a colour, NAME=R,G,B;R,G,B with a number for each letter, got '{}'", typed)};
}

Result<Variation> read_variation(const std::string& typed) {
  const std::size_t equals = typed.find('=');
  Variation variation;
  variation.typed_name = typed.substr(0, equals);
  const std::optional<std::string> canonical = canonical_name(variation.typed_name);
  if (equals == std::string::npos || !canonical) return bad_variation(typed);
  variation.name = *canonical;
  std::string_view rest = std::string_view(typed).substr(equals + 1);
  const char separator = rest.find(';') != std::string_view::npos ? ';' : ',';
  while (true) {
    const std::string_view word = rest.substr(0, rest.find(separator));
    const auto numbers = read_numbers(word);
    if (!numbers) return bad_variation(typed);
    variation.values.push_back(*numbers);
    variation.typed_values.emplace_back(word);
    if (word.size() == rest.size()) return variation;
    rest.remove_prefix(word.size() + 1);
  }
}

std::optional<std::string> usage_fault(PlotOptions& options) {
  if (!options.size.empty()) {
    const auto size = read_picture_size(options.size);
    if (!size) return fmt::format("--size takes WIDTHxHEIGHT, got '{}'", options.size);
    options.look.width = size->width;
    options.look.height = size->height;
  }
  if (auto fault = plots::find_fault(options.request)) return fault;
  if (auto fault = plots::find_fault(options.look)) return fault;
  if (format_of(options.output) == Format::Unknown) {
    return fmt::format("--output has to end with .svg, .png or .csv, got '{}'", options.output);
  }
  if (std::ranges::count(options.files, "-") > 1) return "only one document can be standard input";
  return std::nullopt;
}

std::string stem_of(const std::string& file) {
  if (file == "-") return "standard input";
  const std::string name = file.substr(file.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  return dot == 0 ? name : name.substr(0, dot);
}

/// Joins what the documents and the values give to one plot.
class PlotMaker {
 public:
  PlotMaker(const PlotOptions& options, const std::optional<Variation>& variation)
      : options_(options), variation_(variation) {
    plot_.request = options.request;
    plot_.look = options.look;
    if (options.files.size() == 1) plot_.title = stem_of(options.files.front());
  }

  std::size_t count() const { return options_.files.size() * (variation_ ? variation_->values.size() : 1); }

  /// Says on standard error what is wrong.
  std::optional<ExitCode> add_file(const std::string& file) {
    ModelOptions one = options_.model;
    one.file = file;
    auto loaded = load_model_source(one);
    if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
    ModelSource& source = std::get<ModelSource>(loaded);
    if (source.document_has_errors) status_ = ExitCode::DocumentHasErrors;
    const std::string label = options_.files.size() == 1 ? "" : stem_of(file);
    if (!variation_) return add_series(source, {}, label);
    for (std::size_t i = 0; i < variation_->values.size(); ++i) {
      const std::string value = fmt::format("{} = {}", variation_->typed_name, variation_->typed_values[i]);
      const auto failed = add_series(source, {{variation_->name, variation_->values[i]}},
                                     label.empty() ? value : fmt::format("{}, {}", label, value));
      if (failed) return failed;
    }
    return std::nullopt;
  }

  const plots::Plot& plot() const { return plot_; }
  ExitCode status() const { return status_; }

 private:
  std::optional<ExitCode> add_series(ModelSource& source, const ParameterValues& values, std::string label) {
    Result<ir::Program> program = source.program(values);
    if (!program) return failed(ExitCode::BadUsage, source, program.error());
    const auto model = preview::ExactModel::compile(*std::move(program));
    if (!model) return failed(ExitCode::DocumentHasErrors, source, model.error());
    auto series = plots::sample(*model, std::move(label), options_.request,
                                {.steps = kMostSteps / count(), .refinements = kRefinements});
    if (!series) return failed(ExitCode::DocumentHasErrors, source, series.error());
    plot_.series.push_back(*std::move(series));
    return std::nullopt;
  }

  static ExitCode failed(ExitCode code, const ModelSource& source, std::string_view reason) {
    print_message(fmt::format("{}: {}", source.named.file_names.front(), reason));
    return code;
  }

  const PlotOptions& options_;
  const std::optional<Variation>& variation_;
  plots::Plot plot_;
  ExitCode status_ = ExitCode::Fine;
};

ExitCode bad_usage(std::string_view message) {
  print_message(message);
  return ExitCode::BadUsage;
}

ExitCode plot(PlotOptions& options) {
  if (const auto fault = usage_fault(options)) return bad_usage(*fault);
  std::optional<Variation> variation;
  if (!options.variation.empty()) {
    Result<Variation> read = read_variation(options.variation);
    if (!read) return bad_usage(read.error());
    variation = *std::move(read);
  }
  PlotMaker maker(options, variation);
  if (maker.count() > kMostSeries) {
    return bad_usage(fmt::format("a plot takes up to {} series, got {}", kMostSeries, maker.count()));
  }
  for (const std::string& file : options.files) {
    if (const auto failed = maker.add_file(file)) return *failed;
  }
  if (const auto failure = write_output(options.output, written(maker.plot(), format_of(options.output)))) {
    return bad_usage(failure->message);
  }
  for (const std::string& note : plots::notes_of(maker.plot())) print_message(note);
  return maker.status();
}

void add_request_options(CLI::App& arguments, plots::Request& request) {
  std::map<std::string, plots::View> views;
  std::string descriptions = "what to plot:";
#define VIEW(name, word, description) \
  views[word] = plots::View::name;    \
  descriptions += "\n" word ": " description;
#include "plots/views.def"
#undef VIEW
  arguments.add_option("--view", request.view, descriptions)
      ->transform(CLI::CheckedTransformer(views).description(""))
      ->type_name("VIEW")
      ->required();
  arguments.add_flag("--cosine", request.times_cosine,
                     "times cos θ: of the viewer where the light stands still, else of the light");
  arguments.add_option("--incidence", request.incidence, "degrees of the light from the normal")->capture_default_str();
  arguments.add_option("--phi", request.phi, "degrees of the light (or half vector) around the normal, from X")
      ->capture_default_str();
  arguments.add_option("--theta-h", request.theta_h, "degrees of the half vector, for theta-d")->capture_default_str();
  arguments.add_option("--theta-d", request.theta_d, "degrees of the difference, for theta-h")->capture_default_str();
  arguments
      .add_option("--phi-d", request.phi_d, "degrees of the light around the half vector, for theta-h, theta-d, slice")
      ->capture_default_str();
}

void add_look_options(CLI::App& arguments, PlotOptions& options) {
  plots::Look& look = options.look;
  arguments.add_flag_callback(
      "--log", [&look] { look.scale = plots::ScaleKind::Log; }, "values on a logarithmic scale");
  const std::map<std::string, plots::Channels> channels{{"r", plots::Channels::Red},
                                                        {"g", plots::Channels::Green},
                                                        {"b", plots::Channels::Blue},
                                                        {"all", plots::Channels::All},
                                                        {"luminance", plots::Channels::Luminance}};
  arguments
      .add_option("--channel", look.channels,
                  "of a colour: r, g, b, all or luminance (default: all; of a lobe luminance)")
      ->transform(CLI::CheckedTransformer(channels).description(""))
      ->type_name("CHANNEL");
  arguments.add_option("--max", look.maximum, "where the axis of values ends");
  arguments.add_option("--size", options.size, "pixels (720x480)")->type_name("WIDTHxHEIGHT");
  arguments
      .add_option("--azimuth", look.azimuth, "degrees between a lobe's eye and the mirrored light, around the normal")
      ->capture_default_str();
  arguments.add_option("--elevation", look.elevation, "degrees of a lobe's eye above the surface")
      ->capture_default_str();
}

}  // namespace

Subcommand add_plot(CLI::App& program) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* const arguments = program.add_subcommand("plot", "Plot the BRDF: curves, lobes, albedo, slices");
  arguments->add_option("FILE", options->files, "LaTeX documents, - for standard input")->required();
  add_model_choice(*arguments, options->model);
  arguments
      ->add_option("--vary", options->variation,
                   "several values for a parameter, held against each other: m=0.1,0.2,0.4")
      ->type_name("NAME=A,B,C");
  add_request_options(*arguments, options->request);
  add_look_options(*arguments, *options);
  arguments->add_option("-o,--output", options->output, "the file to write; its ending says what: .svg, .png, .csv")
      ->type_name("OUT")
      ->required();
  return {arguments, [options] { return plot(*options); }};
}

}  // namespace texbrdf::cli

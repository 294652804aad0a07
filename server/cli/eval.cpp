#include <fmt/core.h>

#include <memory>
#include <optional>

#include "cli/csv.h"
#include "cli/files.h"
#include "cli/messages.h"
#include "cli/model.h"
#include "cli/render_fault.h"
#include "cli/subcommands.h"
#include "eval/batch.h"
#include "eval/compile.h"
#include "preview/shader_model.h"
#include "render/worker_client.h"

namespace texbrdf::cli {
namespace {

enum class Device : uint8_t { Cpu, Gpu };
enum class Precision : uint8_t { Double, Single };

struct EvalOptions {
  ModelOptions model;
  std::string directions;
  Device device = Device::Cpu;
  std::optional<Precision> precision;  ///< absent: the best that the device has
  std::string output = "-";
};

using DoubleValues = std::vector<std::array<double, 3>>;
using SingleValues = std::vector<std::array<float, 3>>;

DoubleValues evaluate_double(const eval::CompiledModel& model, std::span<const eval::Geometry> geometries) {
  const eval::ReferenceEvaluator evaluator(model.unoptimised);
  DoubleValues values;
  values.reserve(geometries.size());
  for (const eval::Geometry& geometry : geometries) values.push_back(evaluator.evaluate(geometry, model.parameters));
  return values;
}

/// One coordinate array per component of a vector, as the batch evaluator reads them.
using Coordinates = std::array<std::vector<float>, 3>;

Coordinates coordinates(std::span<const eval::Geometry> geometries, std::array<double, 3> eval::Geometry::* vector) {
  Coordinates arrays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const eval::Geometry& geometry : geometries)
      arrays[axis].push_back(static_cast<float>((geometry.*vector)[axis]));
  }
  return arrays;
}

std::array<const float*, 3> pointers(const Coordinates& arrays) {
  return {arrays[0].data(), arrays[1].data(), arrays[2].data()};
}

SingleValues evaluate_single(const eval::CompiledModel& model, std::span<const eval::Geometry> geometries) {
  const Coordinates light = coordinates(geometries, &eval::Geometry::light);
  const Coordinates view = coordinates(geometries, &eval::Geometry::view);
  const Coordinates normal = coordinates(geometries, &eval::Geometry::normal);
  const Coordinates tangent = coordinates(geometries, &eval::Geometry::tangent);
  const Coordinates bitangent = coordinates(geometries, &eval::Geometry::bitangent);
  const eval::GeometryBatch batch{.count = geometries.size(),
                                  .light = pointers(light),
                                  .view = pointers(view),
                                  .normal = pointers(normal),
                                  .tangent = pointers(tangent),
                                  .bitangent = pointers(bitangent)};
  Coordinates channels;
  for (std::vector<float>& channel : channels) channel.resize(geometries.size());
  eval::BatchEvaluator(model.optimised)
      .evaluate(batch, model.parameters, {channels[0].data(), channels[1].data(), channels[2].data()});
  SingleValues values;
  values.reserve(geometries.size());
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    values.push_back({channels[0][i], channels[1][i], channels[2][i]});
  }
  return values;
}

/// The table that is written, or why there is none (already told).
using CsvOrExit = std::variant<std::string, ExitCode>;

CsvOrExit evaluate_on_cpu(const ir::Program& program, const DirectionTable& table, Precision precision) {
  const Result<eval::CompiledModel> model = eval::compile(program);
  if (!model) {
    print_message(model.error());
    return ExitCode::DocumentHasErrors;
  }
  if (precision == Precision::Double) return write_values(table, evaluate_double(*model, table.rows));
  return write_values(table, evaluate_single(*model, table.rows));
}

CsvOrExit evaluate_on_gpu(const ir::Program& program, const DirectionTable& table) {
  const Result<render::ShaderModel> model = preview::shader_model(program);
  if (!model) {
    print_message(model.error());
    return ExitCode::DocumentHasErrors;
  }
  render::RenderWorker worker;
  const auto values = worker.evaluate(*model, table.rows);
  if (const auto* fault = std::get_if<render::RenderFault>(&values)) {
    return report_render_fault(*fault);
  }
  return write_values(table, std::get<SingleValues>(values));
}

Result<DirectionTable> read_table(const std::string& path) {
  const Result<std::string> bytes = read_input(path);
  if (!bytes) return Failure{bytes.error()};
  Result<DirectionTable> table = read_directions(*bytes);
  if (!table) return Failure{fmt::format("{}: {}", input_name(path), table.error())};
  return table;
}

std::optional<std::string> usage_fault(const EvalOptions& options) {
  if (options.device == Device::Gpu && options.precision == Precision::Double) {
    return "--device gpu computes in single precision";
  }
  if (options.model.file == "-" && options.directions == "-") {
    return "the document and the directions cannot both be standard input";
  }
  return std::nullopt;
}

ExitCode evaluate(const EvalOptions& options) {
  if (const auto fault = usage_fault(options)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  const Result<DirectionTable> table = read_table(options.directions);
  if (!table) {
    print_message(table.error());
    return ExitCode::BadUsage;
  }
  const auto loaded = load_model(options.model);
  if (const auto* failed = std::get_if<ExitCode>(&loaded)) return *failed;
  const Model& model = std::get<Model>(loaded);

  const CsvOrExit csv = options.device == Device::Gpu
                            ? evaluate_on_gpu(model.program, *table)
                            : evaluate_on_cpu(model.program, *table, options.precision.value_or(Precision::Double));
  if (const auto* failed = std::get_if<ExitCode>(&csv)) return *failed;
  if (const auto failure = write_output(options.output, std::get<std::string>(csv))) {
    print_message(failure->message);
    return ExitCode::BadUsage;
  }
  return model.exit_code();
}

}  // namespace

Subcommand add_eval(CLI::App& program) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App* const arguments = program.add_subcommand("eval", "Compute the BRDF's value for given directions");
  add_model_options(*arguments, options->model);
  arguments
      ->add_option(
          "--directions", options->directions,
          "CSV with columns Lx,Ly,Lz,Vx,Vy,Vz and, all or none, Nx,Ny,Nz,Xx,Xy,Xz,Yx,Yy,Yz; - for standard input")
      ->type_name("IN.csv")
      ->required();
  const std::map<std::string, Device> devices{{"cpu", Device::Cpu}, {"gpu", Device::Gpu}};
  arguments->add_option("--device", options->device, "cpu or gpu (through EGL)")
      ->transform(CLI::CheckedTransformer(devices).description(""))
      ->type_name("DEVICE");
  const std::map<std::string, Precision> precisions{{"double", Precision::Double}, {"single", Precision::Single}};
  arguments
      ->add_option("--precision", options->precision, "double (the reference) or single (what previews are drawn with)")
      ->transform(CLI::CheckedTransformer(precisions).description(""))
      ->type_name("PRECISION");
  arguments->add_option("-o,--output", options->output, "the CSV file to write, - for standard output")
      ->type_name("OUT.csv");
  return {arguments, [options] { return evaluate(*options); }};
}

}  // namespace texbrdf::cli

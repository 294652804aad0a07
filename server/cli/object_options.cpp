#include "cli/object_options.h"

#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "cli/files.h"
#include "cli/messages.h"
#include "objects/obj_file.h"
#include "objects/teapot.h"

namespace texbrdf::cli {
namespace {

constexpr uint32_t kMaxSamples = 65'536;
/// The teapot from a little above, its spout turned to the viewer.
constexpr objects::Orbit kTeapotOrbit{-30, 20};

using Mesh = std::shared_ptr<const objects::Mesh>;

Result<Mesh> fitted(Result<objects::Mesh> mesh) {
  if (!mesh) return Failure{mesh.error()};
  fit_into_unit_sphere(*mesh);
  return Mesh(std::make_shared<const objects::Mesh>(*std::move(mesh)));
}

Result<Mesh> read_mesh(const std::string& path) {
  const Result<std::string> bytes = read_input(path);
  if (!bytes) return Failure{bytes.error()};
  Result<Mesh> mesh = fitted(objects::read_obj(*bytes));
  return mesh ? std::move(mesh) : Failure{fmt::format("{}: {}", input_name(path), mesh.error())};
}

Result<Mesh> mesh_of(const std::string& object) {
  if (object == "sphere") return Mesh();
  if (object == "teapot") return fitted(objects::make_teapot());
  if (object.ends_with(".obj")) return read_mesh(object);
  return Failure{fmt::format("--object takes sphere, teapot or a file FILE.obj, not '{}'", object)};
}

std::optional<std::string> find_fault(const ObjectOptions& options) {
  for (const auto& angle : {options.yaw, options.pitch}) {
    if (angle && !(std::abs(*angle) <= 1e6)) return "--yaw and --pitch are angles in degrees";
  }
  if (options.samples < 1 || options.samples > kMaxSamples) {
    return fmt::format("--samples takes 1 to {}, not {}", kMaxSamples, options.samples);
  }
  return std::nullopt;
}

}  // namespace

void add_object_options(CLI::App& arguments, ObjectOptions& options) {
  arguments.add_option("--object", options.object, "what is made of the BRDF: sphere, teapot or a Wavefront FILE.obj")
      ->type_name("OBJECT")
      ->capture_default_str();
  arguments.add_option("--yaw", options.yaw, "degrees that the object is turned around its upright axis");
  arguments.add_option("--pitch", options.pitch, "degrees that its top is tipped towards the viewer");
}

bool is_plain_sphere(const ObjectOptions& options) {
  return options.object == "sphere" && !options.yaw && !options.pitch && options.light == "directional";
}

std::variant<preview::ObjectScene, ExitCode> object_scene(const ObjectOptions& options,
                                                          const render::SphereView& view) {
  if (const auto fault = find_fault(options)) {
    print_message(*fault);
    return ExitCode::BadUsage;
  }
  const Result<Mesh> mesh = mesh_of(options.object);
  if (!mesh) {
    print_message(mesh.error());
    return ExitCode::BadUsage;
  }
  const objects::Orbit suits = *mesh ? kTeapotOrbit : objects::Orbit();
  const objects::Orbit orbit{options.yaw.value_or(suits.yaw), options.pitch.value_or(suits.pitch)};
  return preview::ObjectScene{view, {*mesh, orbit}, nullptr};
}

}  // namespace texbrdf::cli

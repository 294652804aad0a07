#include "cli/object_options.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "cli/files.h"
#include "cli/messages.h"

namespace texbrdf::cli {
namespace {

constexpr uint32_t kMaxSamples = 65'536;

std::optional<std::string> find_fault(const ObjectOptions& options) {
  for (const auto& angle : {options.yaw, options.pitch}) {
    if (angle && !(std::abs(*angle) <= 1e6)) return "--yaw and --pitch are angles in degrees";
  }
  if (options.samples < 1 || options.samples > kMaxSamples) {
    return fmt::format("--samples takes 1 to {}, not {}", kMaxSamples, options.samples);
  }
  return std::nullopt;
}

Result<preview::ObjectScene> make_scene(const ObjectOptions& options, const render::SphereView& view) {
  if (const auto fault = find_fault(options)) return Failure{*fault};
  preview::LightChoice light = options.light;
  light.sky.elevation = options.sun[0];
  light.sky.azimuth = options.sun[1];
  const auto environment = preview::find_environment(light, read_input);
  if (!environment) return Failure{environment.error()};
  const auto mesh = preview::find_mesh(options.object, read_input);
  if (!mesh) return Failure{mesh.error()};
  const objects::Orbit suits = preview::standard_orbit(options.object);
  const objects::Orbit orbit{options.yaw.value_or(suits.yaw), options.pitch.value_or(suits.pitch)};
  return preview::ObjectScene{view, {*mesh, orbit}, *environment};
}

}  // namespace

void add_object_options(CLI::App& arguments, ObjectOptions& options) {
  arguments.add_option("--object", options.object, "what is made of the BRDF: sphere, teapot or a Wavefront FILE.obj")
      ->type_name("OBJECT")
      ->capture_default_str();
  arguments.add_option("--yaw", options.yaw, "degrees that the object is turned around its upright axis");
  arguments.add_option("--pitch", options.pitch, "degrees that its top is tipped towards the viewer");
  arguments
      .add_option(
          "--light", options.light.light,
          "what lights it: directional (--theta, --phi), sky, furnace (1 from everywhere) or a Radiance FILE.hdr")
      ->type_name("LIGHT")
      ->capture_default_str();
  arguments
      .add_option("--sun", options.sun,
                  "degrees of the sky's sun over the horizon, and from behind the viewer to his right")
      ->delimiter(',')
      ->type_name("ELEVATION,AZIMUTH")
      ->default_str("45,-30");
  arguments.add_option("--turbidity", options.light.sky.turbidity, "haze of the sky, 2 to 10")->capture_default_str();
}

bool is_plain_sphere(const ObjectOptions& options) {
  return options.object == "sphere" && !options.yaw && !options.pitch && options.light.light == "directional";
}

std::variant<preview::ObjectScene, ExitCode> object_scene(const ObjectOptions& options,
                                                          const render::SphereView& view) {
  Result<preview::ObjectScene> scene = make_scene(options, view);
  if (scene) return *std::move(scene);
  print_message(scene.error());
  return ExitCode::BadUsage;
}

}  // namespace texbrdf::cli

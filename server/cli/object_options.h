#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "cli/exit_code.h"
#include "preview/object_choice.h"
#include "preview/object_picture.h"

namespace texbrdf::cli {

/// What `render` draws beside the plain sphere, as typed.
struct ObjectOptions {
  std::string object = "sphere";
  preview::LightChoice light;
  std::array<double, 2> sun{light.sky.elevation, light.sky.azimuth};  ///< degrees
  std::optional<double> yaw;                                          ///< degrees; else what suits the object
  std::optional<double> pitch;                                        ///< degrees
  uint32_t samples = 256;
};

void add_object_options(CLI::App& arguments, ObjectOptions& options);

/// Whether it is the sphere of `--view sphere` and nothing else.
bool is_plain_sphere(const ObjectOptions& options);

/// Reads the files that the options name; says on standard error why it cannot.
std::variant<preview::ObjectScene, ExitCode> object_scene(const ObjectOptions& options, const render::SphereView& view);

}  // namespace texbrdf::cli

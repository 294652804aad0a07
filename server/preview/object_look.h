#pragma once

#include <cstdint>
#include <string>

#include "objects/rasterise.h"
#include "preview/object_choice.h"

namespace texbrdf::preview {

/// What a preview shows of a BRDF beside the sphere in the directional light.
struct ObjectLook {
  std::string shape = "sphere";  ///< or teapot, or the absolute path of a .obj file
  LightChoice light;             ///< a .hdr file by its absolute path
  objects::Orbit orbit;
  uint32_t samples = 64;
  std::string shape_problem = {};  ///< why the file may not be had; empty where it may
  std::string light_problem = {};
  /// The sphere of `--view sphere`.
  bool is_plain() const { return shape == "sphere" && light.light == "directional"; }
  friend bool operator==(const ObjectLook&, const ObjectLook&) = default;
};

}  // namespace texbrdf::preview

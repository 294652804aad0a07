#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lighting/environment.h"
#include "lighting/sky.h"
#include "objects/mesh.h"
#include "objects/rasterise.h"
#include "source/result.h"

namespace texbrdf::preview {

/// The bytes of a file, or why it cannot be read.
using FileReader = std::function<Result<std::string>(const std::string& path)>;

/// What lights an object, as people name it.
struct LightChoice {
  std::string light = "directional";  ///< or sky, furnace, FILE.hdr
  lighting::Sky sky;
  friend bool operator==(const LightChoice&, const LightChoice&) = default;
};

/// The mesh of `sphere` (which has none), `teapot` or FILE.obj, in the unit sphere.
Result<std::shared_ptr<const objects::Mesh>> find_mesh(const std::string& object, const FileReader& read);

/// Nothing for the directional light.
Result<std::shared_ptr<const lighting::Environment>> find_environment(const LightChoice& choice,
                                                                      const FileReader& read);

/// From where an object shows most, unless something else is wanted: the teapot from a little above, its spout turned
/// to the viewer.
objects::Orbit standard_orbit(const std::string& object);

}  // namespace texbrdf::preview

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program.h"
#include "preview/cpu_frame.h"
#include "render/sphere.h"

namespace texbrdf::preview {

/// Width and height of the picture of an expression, in pixels.
inline constexpr uint32_t kLookSize = 64;

/// The values of an expression at a glance.
struct ExpressionLook {
  /// Of each component, among the samples; both are the value where it is the same in all directions. Empty where all
  /// samples are NaN.
  std::vector<double> least;
  std::vector<double> most;
  bool has_nan = false;      ///< a sample is NaN
  std::vector<uint8_t> png;  ///< over the sphere; empty where the value is the same in all directions
};

/// Samples expressions on one thread.
///
/// The picture is that of a preview that nobody has changed: its light, exposure and gamma, bad values marked. A
/// direction (a triple that is of unit length everywhere, or negative somewhere) is drawn as a normal map is:
/// 0.5 + 0.5 v. The samples are pairs of directions above the surface, spread evenly; one in four is a mirrored pair,
/// one in four light and viewer in the same place.
class ExpressionSampler {
 public:
  ExpressionSampler();

  /// Nothing where the program cannot be evaluated.
  std::optional<ExpressionLook> look(const ir::Program& program);

 private:
  using Vectors = render::SphereGeometry::Vectors;

  std::vector<uint8_t> draw(const CpuModel& model, bool as_directions);

  Vectors lights_;
  Vectors views_;
  Vectors normals_;
  Vectors tangents_;
  Vectors bitangents_;
  render::SphereCache sphere_;
};

}  // namespace texbrdf::preview

#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "lighting/environment.h"

namespace texbrdf::lighting {

/// One term of the sum that approaches the light which a point reflects: f(direction) · weight.
struct LightSample {
  glm::dvec3 direction{0};  ///< towards the light; a unit vector
  glm::dvec3 weight{0};     ///< radiance · cosine / density; nothing below the horizon
};

/// The numbers that a pixel's samples come from: the same for the same pixel.
class SampleSequence {
 public:
  explicit SampleSequence(uint32_t pixel);
  glm::dvec2 at(uint32_t index) const;
  /// A number of the pixel's own, for what shall not be the same in all pixels.
  uint32_t shift() const { return shift_; }

 private:
  glm::dvec2 start_;
  uint32_t shift_;
};

/// Sample `index` of a point with this normal. Every second is chosen by cosine, the others by luminance; weighted with
/// the balance heuristic for as many of one as of the other (E. Veach, Robust Monte Carlo Methods for Light Transport
/// Simulation, Stanford 1997, section 9.2). Which comes first is the pixel's chance, so that the mean of any number of
/// samples is unbiased. Where the light is uniform all are chosen by cosine.
LightSample sample_light(const Environment& environment, const glm::dvec3& normal, const SampleSequence& sequence,
                         uint32_t index);

}  // namespace texbrdf::lighting

#include "lighting/light_sample.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace texbrdf::lighting {

namespace {

constexpr double kPi = std::numbers::pi;
/// The generalised golden ratio of two dimensions: places g, g² (M. Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018), with 1/g³ = 1 + 1/g².
constexpr double kStepX = 0.7548776662466927600;
constexpr double kStepY = 0.5698402909980532659;

/// A permutation of 32 bits that mixes them well (C. Wellons, lowbias32, 2018).
uint32_t mix(uint32_t bits) {
  bits ^= bits >> 16;
  bits *= 0x7feb352dU;
  bits ^= bits >> 15;
  bits *= 0x846ca68bU;
  return bits ^ (bits >> 16);
}

double unit_number(uint32_t bits) {
  return bits * 0x1p-32;
}

double fraction(double number) {
  return number - std::floor(number);
}

/// Two unit vectors at right angles to each other and to the unit vector `normal`.
struct Plane {
  glm::dvec3 first;
  glm::dvec3 second;
};

Plane plane_of(const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 first = glm::normalize(glm::cross(other, normal));
  return {first, glm::cross(normal, first)};
}

/// With the density cosine / π.
glm::dvec3 sample_by_cosine(const glm::dvec3& normal, const glm::dvec2& random) {
  const double radius = std::sqrt(random.x);
  const double around = 2 * kPi * random.y;
  const Plane plane = plane_of(normal);
  return plane.first * (radius * std::cos(around)) + plane.second * (radius * std::sin(around)) +
         normal * std::sqrt(1 - random.x);
}

}  // namespace

SampleSequence::SampleSequence(uint32_t pixel)
    : start_(unit_number(mix(pixel * 2 + 1)), unit_number(mix(mix(pixel) + 0x9e3779b9U))), shift_(mix(pixel + 1)) {}

glm::dvec2 SampleSequence::at(uint32_t index) const {
  return {fraction(start_.x + index * kStepX), fraction(start_.y + index * kStepY)};
}

LightSample sample_light(const Environment& environment, const glm::dvec3& normal, const SampleSequence& sequence,
                         uint32_t index) {
  const bool both = !environment.is_uniform();
  const bool by_luminance = both && ((index + sequence.shift()) & 1) != 0;
  const glm::dvec2 random = sequence.at(both ? index / 2 : index);
  LightSample sample;
  sample.direction = by_luminance ? environment.sample(random) : sample_by_cosine(normal, random);
  const double cosine = glm::dot(normal, sample.direction);
  if (!(cosine > 0)) return sample;
  const double by_cosine = cosine / kPi;
  const double density = both ? (by_cosine + environment.density(sample.direction)) / 2 : by_cosine;
  sample.weight = glm::dvec3(environment.radiance(sample.direction)) * (cosine / density);
  return sample;
}

}  // namespace texbrdf::lighting

#include "features/sample_geometries.h"

#include <cmath>

namespace texbrdf::features {
namespace {

eval::Geometry geometry_of(const eval::Triple& light, const eval::Triple& view) {
  const auto unit = [](const eval::Triple& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return eval::Triple{v[0] / length, v[1] / length, v[2] / length};
  };
  return {.light = unit(light), .view = unit(view)};
}

}  // namespace

const std::vector<eval::Geometry>& sample_geometries() {
  static const std::vector<eval::Geometry> all = {
      geometry_of({0.3, 0.1, 0.9}, {-0.2, 0.4, 0.8}),  geometry_of({0.8, -0.3, 0.4}, {0.1, 0.2, 0.9}),
      geometry_of({-0.5, 0.6, 0.5}, {0.7, 0.1, 0.6}),  geometry_of({0.1, 0.9, 0.3}, {0.3, 0.7, 0.6}),
      geometry_of({-0.9, -0.2, 0.2}, {0.9, 0.3, 0.3}), geometry_of({0.2, -0.6, 0.7}, {-0.6, -0.6, 0.4}),
  };
  return all;
}

}  // namespace texbrdf::features

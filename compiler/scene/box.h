#pragma once

#include <glm/vec3.hpp>
#include <limits>

#include "scene/frame.h"

namespace texbrdf::scene {

/// A box along the axes, which may reach to infinity; as it is made, it is empty.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  bool is_empty() const;
  bool is_bounded() const;          ///< neither empty nor infinite
  bool is_bounded(int axis) const;  ///< where it is not empty
  glm::dvec3 centre() const { return (low + high) / 2.0; }
  glm::dvec3 half() const { return (high - low) / 2.0; }
  /// The largest half size of a bounded box.
  double size() const;
};

Box box_around(const glm::dvec3& centre, const glm::dvec3& half);
Box everything();
Box hull(const Box& a, const Box& b);
Box intersection(const Box& a, const Box& b);
Box grown(const Box& box, double distance);
/// Of a box in the frame: one in its parent.
Box in_parent(const Frame& frame, const Box& box);

}  // namespace texbrdf::scene

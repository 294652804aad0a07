#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "render/bad_pixels.h"
#include "render/image.h"
#include "render/sphere.h"

namespace texbrdf::render {

/// A picture and what is wrong with it.
struct Picture {
  ImageRgba8 image;
  BadPixelCounts bad_pixels;
};

/// Values of f at the points of a geometry; `stride` floats from one point to the next in each channel.
struct ShadedValues {
  std::array<const float*, 3> channels;
  std::size_t stride = 1;
};

/// (f · N·L · 2^exposure)^(1/gamma), or without N·L, rounded exactly, with bad values marked and counted: the same for
/// every device.
class ToneMapper {
 public:
  /// Both outlive the mapper.
  ToneMapper(const SphereGeometry& geometry, const SphereView& view);
  ~ToneMapper();
  ToneMapper(const ToneMapper&) = delete;
  ToneMapper& operator=(const ToneMapper&) = delete;

  /// `values` begin at the point `first`.
  void add(std::size_t first, std::size_t count, const ShadedValues& values);
  /// The points that were not added are black.
  Picture take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All points at once.
Picture tone_map(const SphereGeometry& geometry, const SphereView& view, const ShadedValues& values);

/// Unit vectors as a normal map shows them: 0.5 + 0.5 v. What is no number is marked; negative values are in order.
Picture map_directions(const SphereGeometry& geometry, const ShadedValues& values);

}  // namespace texbrdf::render

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "preview/exact_model.h"
#include "render/bad_pixels.h"
#include "render/sphere.h"

namespace texbrdf::preview {

/// A bad pixel, and where its value comes from.
struct BadValue {
  render::PicturePlace place;
  render::BadPixel kind = render::BadPixel::NotANumber;
  std::string origin;  ///< canonical name of a quantity
};

struct BadValues {
  uint32_t size = 0;  ///< pixels, width and height of the picture that was searched
  render::BadPixelCounts counts;
  std::optional<BadValue> first;
  std::string problem;  ///< why the search ended early; one line for a person
};

/// Draws the picture anew, at most 256 pixels wide, smaller where the BRDF is slow, and counts its bad pixels. `first`
/// is the first of them, row by row, that the reference evaluator finds bad as well, with the kind that it finds.
BadValues find_bad_values(const ExactModel& model, const render::SphereView& view);

/// Nothing was searched.
BadValues no_bad_values(std::string problem);

/// The quantity that a bad value comes from: from the BRDF on, as long as something that is needed directly (or by a
/// function that is called) is bad as well, the first of those in order of need. NaN comes from NaN, else from an
/// infinite value; a negative one from negative numbers, not from directions. `values`: of all quantities.
const Quantity& origin_of(const ExactModel& model, std::span<const eval::Triple> values, render::BadPixel kind);

}  // namespace texbrdf::preview

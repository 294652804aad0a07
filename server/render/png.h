#pragma once

#include <cstdint>
#include <vector>

#include "render/image.h"

namespace texbrdf::render {

enum class PngEffort : uint8_t {
  Fast,   ///< for a frame that is looked at once
  Small,  ///< for a file
};

/// A PNG file with eight bits a channel: RGB where every pixel is opaque, RGBA otherwise.
/// The image has at least one pixel.
std::vector<uint8_t> encode_png(const ImageRgba8& image, PngEffort effort);

}  // namespace texbrdf::render

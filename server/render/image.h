#pragma once

#include <cstdint>
#include <vector>

namespace texbrdf::render {

/// Ready for a display, straight (not premultiplied) alpha; rows from top to bottom.
struct ImageRgba8 {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> pixels;  ///< red, green, blue, alpha of each pixel

  const uint8_t* at(uint32_t x, uint32_t y) const { return &pixels[(std::size_t{y} * width + x) * 4]; }
};

}  // namespace texbrdf::render

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace texbrdf::cli {

struct PictureSize {
  uint32_t width = 0;
  uint32_t height = 0;
};

/// "720x480", or "480" for a square; nothing where it is neither.
std::optional<PictureSize> read_picture_size(std::string_view typed);

}  // namespace texbrdf::cli

#pragma once

#include <cstddef>
#include <string_view>

#include "lighting/environment.h"
#include "source/result.h"

namespace texbrdf::lighting {

inline constexpr std::size_t kMaxHdrTexels = std::size_t{1} << 25;

/// A Radiance picture (.hdr, .pic) of all directions, twice as wide as high; formats: G. Ward, Radiance file formats.
/// 32-bit_rle_rgbe only, in any of the encodings (plain, old and new runs), rows from top or bottom, columns from left
/// or right. A channel is mantissa · 2^(exponent - 136), divided by all EXPOSURE and COLORCORR of the header; taken as
/// linear sRGB. Fails with a reason for all else, for files that end too early, and for black ones.
Result<EnvironmentMap> read_hdr(std::string_view bytes);

}  // namespace texbrdf::lighting

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::render {

/// What can be wrong with the value of a pixel, from bad_pixels.def; the first that holds counts.
enum class BadPixel : uint8_t {
#define BAD_PIXEL(name, red, green, blue, words, colour_name) name,
#include "render/bad_pixels.def"
#undef BAD_PIXEL
};

inline constexpr std::array kBadPixelKinds{
#define BAD_PIXEL(name, red, green, blue, words, colour_name) BadPixel::name,
#include "render/bad_pixels.def"
#undef BAD_PIXEL
};

struct BadPixelEntry {
  BadPixel kind;
  std::array<uint8_t, 3> colour;  ///< what such a pixel shows
  std::string_view words;         ///< "not a number"
  std::string_view colour_name;   ///< "magenta"
};

const BadPixelEntry& bad_pixel_entry(BadPixel kind);

/// What is wrong with a value, or nothing.
template <typename Number>
std::optional<BadPixel> find_bad(const std::array<Number, 3>& value) {
  constexpr Number kInfinity = std::numeric_limits<Number>::infinity();
  const auto is_fine = [](Number x) { return x >= 0 && x < kInfinity; };
  if (is_fine(value[0]) && is_fine(value[1]) && is_fine(value[2])) return std::nullopt;
  const auto any = [&](auto&& is_bad) { return std::any_of(value.begin(), value.end(), is_bad); };
  if (any([](Number x) { return std::isnan(x); })) return BadPixel::NotANumber;
  if (any([](Number x) { return std::isinf(x); })) return BadPixel::Infinite;
  return BadPixel::Negative;
}

/// Pixels of a picture by what is wrong with them.
struct BadPixelCounts {
  std::array<uint32_t, kBadPixelKinds.size()> counts{};

  uint32_t& operator[](BadPixel kind) { return counts[static_cast<std::size_t>(kind)]; }
  uint32_t operator[](BadPixel kind) const { return counts[static_cast<std::size_t>(kind)]; }
  uint32_t total() const;
  friend bool operator==(const BadPixelCounts&, const BadPixelCounts&) = default;
};

/// "12 pixels are not a number (magenta), 3 are negative (yellow)"; empty where nothing is wrong.
std::string describe(const BadPixelCounts& counts);

}  // namespace texbrdf::render

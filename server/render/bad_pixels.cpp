#include "render/bad_pixels.h"

#include <fmt/format.h>

#include <numeric>

namespace texbrdf::render {

namespace {

constexpr std::array kEntries{
#define BAD_PIXEL(name, red, green, blue, words, colour_name) \
  BadPixelEntry{BadPixel::name, {red, green, blue}, words, colour_name},
#include "render/bad_pixels.def"
#undef BAD_PIXEL
};

}  // namespace

const BadPixelEntry& bad_pixel_entry(BadPixel kind) {
  return kEntries[static_cast<std::size_t>(kind)];
}

uint32_t BadPixelCounts::total() const {
  return std::accumulate(counts.begin(), counts.end(), 0U);
}

std::string describe(const BadPixelCounts& counts) {
  std::string text;
  for (const BadPixelEntry& entry : kEntries) {
    const uint32_t count = counts[entry.kind];
    if (count == 0) continue;
    const std::string_view subject = text.empty() ? (count == 1 ? " pixel" : " pixels") : "";
    text += fmt::format("{}{}{} {} {} ({})", text.empty() ? "" : ", ", count, subject, count == 1 ? "is" : "are",
                        entry.words, entry.colour_name);
  }
  return text;
}

}  // namespace texbrdf::render

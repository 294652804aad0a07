#include "render/base64.h"

#include <algorithm>
#include <string_view>

namespace texbrdf::render {

std::string base64(std::span<const uint8_t> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3;
  std::string text((bytes.size() + kGroup - 1) / kGroup * 4, '=');
  for (std::size_t i = 0, out = 0; i < bytes.size(); i += kGroup, out += 4) {
    const std::size_t count = std::min(kGroup, bytes.size() - i);
    uint32_t group = 0;
    for (std::size_t k = 0; k < kGroup; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k <= count; ++k) text[out + k] = kDigits[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

}  // namespace texbrdf::render

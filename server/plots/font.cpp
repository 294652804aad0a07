#include "plots/font.h"

#include <algorithm>

namespace texbrdf::plots {

double text_width(std::string_view text, double size) {
  constexpr double kWideLetter = 0.66;  // of the size: wider than most
  const auto is_start = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return kWideLetter * size * static_cast<double>(std::ranges::count_if(text, is_start));
}

}  // namespace texbrdf::plots

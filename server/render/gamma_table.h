#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace texbrdf::render {

/// Brings a linear value in [0, 1] to eight bits: round(255 · value^(1/gamma)), exactly. The bits of a float, cut
/// to exponent and a few digits, index a table of first guesses; the thresholds between neighbouring levels decide.
class GammaTable {
 public:
  explicit GammaTable(double gamma);

  uint8_t operator()(float value) const {
    if (!(value > 0)) return 0;
    if (value >= 1) return 255;
    uint32_t level = guesses_[std::bit_cast<uint32_t>(value) >> kDroppedBits];
    while (value >= thresholds_[level + 1]) ++level;
    return static_cast<uint8_t>(level);
  }

 private:
  static constexpr uint32_t kDroppedBits = 16;
  static constexpr uint32_t kCells = (std::bit_cast<uint32_t>(1.0F) >> kDroppedBits) + 1;

  /// The least value of each level; 256 is never reached.
  std::array<float, 257> thresholds_{};
  std::array<uint8_t, kCells> guesses_{};
};

}  // namespace texbrdf::render

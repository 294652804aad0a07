#include "render/gamma_table.h"

#include <cmath>
#include <limits>

namespace texbrdf::render {

GammaTable::GammaTable(double gamma) {
  for (std::size_t level = 1; level < thresholds_.size(); ++level) {
    thresholds_[level] = static_cast<float>(std::pow((static_cast<double>(level) - 0.5) / 255, gamma));
  }
  thresholds_.back() = std::numeric_limits<float>::infinity();
  uint32_t level = 0;
  for (uint32_t cell = 0; cell < guesses_.size(); ++cell) {
    const float least = std::bit_cast<float>(cell << kDroppedBits);
    while (least >= thresholds_[level + 1]) ++level;
    guesses_[cell] = static_cast<uint8_t>(level);
  }
}

}  // namespace texbrdf::render

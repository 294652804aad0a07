#include "plots/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace texbrdf::plots {
namespace {

constexpr std::array<std::string_view, 7> kWords = {
#define VIEW(name, word, description) word,
#include "plots/views.def"
#undef VIEW
};

constexpr double kRightAngle = 90;
/// Beyond this a turn is a slip of the fingers, and degrees have lost digits.
constexpr double kMostTurn = 3600;

bool is_between(double angle, double low, double high) {
  return angle >= low && angle <= high;  // false for NaN
}

}  // namespace

std::string_view word_of(View view) {
  return kWords[static_cast<std::size_t>(view)];
}

std::optional<View> view_of(std::string_view word) {
  const auto found = std::ranges::find(kWords, word);
  if (found == kWords.end()) return std::nullopt;
  return static_cast<View>(found - kWords.begin());
}

std::string view_words() {
  std::string words(kWords.front());
  for (const std::string_view word : std::span(kWords).subspan(1)) words.append(", ").append(word);
  return words;
}

std::optional<std::string> find_fault(const Request& request) {
  if (!(request.incidence >= 0 && request.incidence < kRightAngle)) {
    return fmt::format("the incidence has to be an angle of 0 to below 90 degrees, got {}", request.incidence);
  }
  if (!is_between(request.theta_h, 0, kRightAngle)) {
    return fmt::format("theta-h has to be an angle of 0 to 90 degrees, got {}", request.theta_h);
  }
  if (!is_between(request.theta_d, 0, kRightAngle)) {
    return fmt::format("theta-d has to be an angle of 0 to 90 degrees, got {}", request.theta_d);
  }
  if (!is_between(request.phi, -kMostTurn, kMostTurn)) {
    return fmt::format("phi has to be an angle of -3600 to 3600 degrees, got {}", request.phi);
  }
  if (!is_between(request.phi_d, -kMostTurn, kMostTurn)) {
    return fmt::format("phi-d has to be an angle of -3600 to 3600 degrees, got {}", request.phi_d);
  }
  return std::nullopt;
}

}  // namespace texbrdf::plots

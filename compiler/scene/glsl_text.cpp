#include "scene/glsl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "source/internal_error.h"

namespace texbrdf::scene {

std::string float_text(double number) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  std::string text = fmt::format("{}", static_cast<float>(std::clamp(number, -kLargest, kLargest)));
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string vector_text(const glm::dvec3& vector) {
  return fmt::format("vec3({}, {}, {})", float_text(vector.x), float_text(vector.y), float_text(vector.z));
}

std::string matrix_text(const glm::dmat3& matrix) {
  return fmt::format("mat3({}, {}, {})", vector_text(matrix[0]), vector_text(matrix[1]), vector_text(matrix[2]));
}

std::string choice_text(std::string_view variable, std::span<const std::pair<uint32_t, std::string>> cases) {
  require(!cases.empty(), "choice_text of nothing");
  if (cases.size() == 1) return cases.front().second;
  const std::size_t half = cases.size() / 2;
  return fmt::format("if ({} < {}) {{ {} }} else {{ {} }}", variable, cases[half].first,
                     choice_text(variable, cases.first(half)), choice_text(variable, cases.subspan(half)));
}

}  // namespace texbrdf::scene

#include "features/value_text.h"

#include <fmt/format.h>

namespace texbrdf::features {

std::string value_text(std::span<const double> value, int digits) {
  std::string numbers;
  for (const double number : value) numbers += fmt::format("{}{:.{}g}", numbers.empty() ? "" : ", ", number, digits);
  return value.size() == 1 ? numbers : fmt::format("({})", numbers);
}

}  // namespace texbrdf::features

#include "features/value_text.h"

#include <fmt/format.h>

namespace texbrdf::features {

std::string value_text(std::span<const double> value) {
  std::string numbers;
  for (const double number : value) numbers += fmt::format("{}{:.7g}", numbers.empty() ? "" : ", ", number);
  return value.size() == 1 ? numbers : fmt::format("({})", numbers);
}

}  // namespace texbrdf::features

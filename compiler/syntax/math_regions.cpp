#include "syntax/math_regions.h"

#include <algorithm>
#include <iterator>

namespace texbrdf {
namespace {

constexpr MathEnvironment kEnvironments[] = {
#define MATH_ENVIRONMENT(name, role, has_columns, has_argument) \
  {name, MathEnvironment::Role::role, has_columns, has_argument},
#include "syntax/math_regions.def"
#undef MATH_ENVIRONMENT
};

}  // namespace

std::string_view opener_of(MathRegion region) {
  switch (region) {
    case MathRegion::Environment:
      return "";
    case MathRegion::Brackets:
      return "\\[";
    case MathRegion::DoubleDollars:
      return "$$";
    case MathRegion::Parentheses:
      return "\\(";
    case MathRegion::Dollars:
      return "$";
  }
  return "";
}

std::string_view closer_of(MathRegion region) {
  switch (region) {
    case MathRegion::Brackets:
      return "\\]";
    case MathRegion::Parentheses:
      return "\\)";
    case MathRegion::Environment:
    case MathRegion::DoubleDollars:
    case MathRegion::Dollars:
      return opener_of(region);
  }
  return "";
}

const MathEnvironment* find_math_environment(std::string_view name) {
  if (name.ends_with('*')) name.remove_suffix(1);
  const auto* const found = std::ranges::find(kEnvironments, name, &MathEnvironment::name);
  return found == std::end(kEnvironments) ? nullptr : found;
}

bool is_display_environment(std::string_view name) {
  const MathEnvironment* const environment = find_math_environment(name);
  return environment != nullptr && environment->role == MathEnvironment::Role::Display;
}

}  // namespace texbrdf

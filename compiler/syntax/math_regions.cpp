#include "syntax/math_regions.h"

#include <algorithm>
#include <iterator>

namespace texbrdf {
namespace {

constexpr MathEnvironment kEnvironments[] = {
#define MATH_ENVIRONMENT(name, role, has_columns, has_argument) \
  {name, MathEnvironment::Role::role, has_columns, has_argument},
#include "syntax/math_regions.def"
};

constexpr MathShortcut kShortcuts[] = {
#define MATH_SHORTCUT(opener, closer, has_columns) {opener, closer, has_columns},
#include "syntax/math_regions.def"
};

}  // namespace

std::string_view opener_of(MathRegion region) {
  switch (region) {
    case MathRegion::Environment:
    case MathRegion::Shortcut:
      return "";
    case MathRegion::Fence:
      return "```math";
    case MathRegion::BacktickDollars:
      return "$`";
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
    case MathRegion::Fence:
      return "```";
    case MathRegion::BacktickDollars:
      return "`$";
    case MathRegion::Environment:
    case MathRegion::Shortcut:
    case MathRegion::DoubleDollars:
    case MathRegion::Dollars:
      return opener_of(region);
  }
  return "";
}

std::span<const MathEnvironment> math_environments() {
  return kEnvironments;
}

const MathEnvironment* find_math_environment(std::string_view name) {
  if (name.ends_with('*')) name.remove_suffix(1);
  const auto* const found = std::ranges::find(kEnvironments, name, &MathEnvironment::name);
  return found == std::end(kEnvironments) ? nullptr : found;
}

std::string_view environment_name(std::string_view begin) {
  const size_t open = begin.find('{');
  if (open == std::string_view::npos) return {};
  begin.remove_prefix(open + 1);
  return begin.substr(0, begin.find('}'));
}

const MathShortcut* find_math_shortcut(std::string_view opener) {
  const auto* const found = std::ranges::find(kShortcuts, opener, &MathShortcut::opener);
  return found == std::end(kShortcuts) ? nullptr : found;
}

bool is_display_environment(std::string_view name) {
  const MathEnvironment* const environment = find_math_environment(name);
  return environment != nullptr && environment->role == MathEnvironment::Role::Display;
}

}  // namespace texbrdf

#include "semantics/implied_angle.h"

#include <array>
#include <utility>

namespace texbrdf {
namespace {

constexpr auto kAngles = std::to_array<std::pair<std::string_view, Convention>>({
    {"\\theta", Convention::ThetaI},
    {"\\vartheta", Convention::ThetaI},
    {"\\phi", Convention::PhiI},
    {"\\varphi", Convention::PhiI},
});

std::string_view without(std::string_view text, std::string_view before, std::string_view behind) {
  if (!text.starts_with(before) || !text.ends_with(behind) || text.size() < before.size() + behind.size()) return text;
  return text.substr(before.size(), text.size() - before.size() - behind.size());
}

}  // namespace

std::string_view direction_label(std::string_view name) {
  const std::string_view bare = without(name, "\\vec{", "}");
  if (bare == "\\omega") return {};
  return without(without(bare, "\\omega_", ""), "{", "}");
}

std::optional<ImpliedAngle> implied_angle(std::string_view name) {
  for (const auto& [letter, kind] : kAngles) {
    if (!name.starts_with(letter)) continue;
    const std::string_view rest = name.substr(letter.size());
    if (rest.empty()) return ImpliedAngle{kind, {}};
    if (!rest.starts_with('_')) continue;
    return ImpliedAngle{kind, direction_label(without(rest.substr(1), "{", "}"))};
  }
  return std::nullopt;
}

}  // namespace texbrdf

#include "semantics/component.h"

#include "semantics/names.h"

namespace texbrdf {
namespace {

std::optional<uint32_t> axis_of(char letter) {
  if (letter == 'w') return 3;
  return letter >= 'x' && letter <= 'z' ? std::optional(static_cast<uint32_t>(letter - 'x')) : std::nullopt;
}

/// What a name without its subscript may be written as: `h` and `\vec{h}`.
std::vector<std::string> owners(const std::string& name) {
  std::vector<std::string> found;
  for (const std::string& spelling : {name, "\\vec{" + name + "}"}) {
    if (std::optional<std::string> canonical = canonical_name(spelling)) found.push_back(*std::move(canonical));
  }
  return found;
}

/// From 1 to 4, counted from 0.
std::optional<uint32_t> take_index(std::string_view& text) {
  if (text.empty() || text.front() < '1' || text.front() > '4') return std::nullopt;
  const auto index = static_cast<uint32_t>(text.front() - '1');
  text.remove_prefix(1);
  return index;
}

bool take(std::string_view& text, char expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

namespace {

constexpr uint32_t kNormalAxis = 2;

/// The cosines of the directions, as papers on planets and on plants write them.
std::optional<ComponentName> cosine_name(std::string_view canonical) {
  if (canonical == "\\mu_0" || canonical == "\\mu_i") return ComponentName{{"\\omega_i"}, kNormalAxis};
  const bool is_outgoing = canonical == "\\mu" || canonical == "\\mu_o" || canonical == "\\mu_r";
  if (is_outgoing) return ComponentName{{"\\omega_o"}, kNormalAxis};
  return std::nullopt;
}

}  // namespace

std::optional<ComponentName> component_name(std::string_view canonical) {
  if (std::optional<ComponentName> cosine = cosine_name(canonical)) return cosine;
  size_t closers = 0;
  while (canonical.ends_with('}')) {
    canonical.remove_suffix(1);
    ++closers;
  }
  if (canonical.size() < 3) return std::nullopt;
  const std::optional<uint32_t> axis = axis_of(canonical.back());
  const char before = canonical[canonical.size() - 2];
  const bool is_separated = before == '_' || (before == ',' && closers > 0);
  if (!axis || !is_separated) return std::nullopt;
  std::string vector(canonical.substr(0, canonical.size() - 2));
  vector.append(closers, '}');
  ComponentName found{.vectors = owners(vector), .axis = *axis};
  return found.vectors.empty() ? std::nullopt : std::optional(std::move(found));
}

std::optional<EntryName> entry_name(std::string_view canonical) {
  if (std::optional<ComponentName> component = component_name(canonical)) {
    return EntryName{.aggregates = std::move(component->vectors), .row = component->axis, .column = {}};
  }
  const size_t underscore = canonical.rfind('_');
  if (underscore == std::string_view::npos) return std::nullopt;
  std::string_view rest = canonical.substr(underscore + 1);
  const bool is_braced = take(rest, '{');
  const std::optional<uint32_t> row = take_index(rest);
  if (!row) return std::nullopt;
  EntryName found{.aggregates = {}, .row = *row, .column = {}};
  if (is_braced) {
    take(rest, ',');
    found.column = take_index(rest);
    if (!found.column || !take(rest, '}')) return std::nullopt;
  }
  if (rest.find_first_not_of('}') != std::string_view::npos) return std::nullopt;
  found.aggregates = owners(std::string(canonical.substr(0, underscore)).append(rest));
  return found.aggregates.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace texbrdf

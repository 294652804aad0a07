#include "emit/helpers.h"

#include <algorithm>
#include <array>

namespace texbrdf::emit {
namespace {

struct HelperEntry {
  std::string_view name;
  std::string_view text;
};

constexpr auto kHelpers = std::to_array<HelperEntry>({
#define HELPER(id, name, text) {name, text},
#define HELPER_OF_TRIPLES(id, text)
#include "emit/helpers.def"
#undef HELPER
#undef HELPER_OF_TRIPLES
});

/// Each helper has one.
constexpr auto kTextsOfTriples = std::to_array<std::string_view>({
#define HELPER(id, name, text)
#define HELPER_OF_TRIPLES(id, text) text,
#include "emit/helpers.def"
#undef HELPER
#undef HELPER_OF_TRIPLES
});
static_assert(kTextsOfTriples.size() == kHelpers.size());

const HelperEntry& entry(Helper helper) {
  return kHelpers[static_cast<std::size_t>(helper)];
}

std::string_view text_of_triples(Helper helper) {
  return kTextsOfTriples[static_cast<std::size_t>(helper)];
}

/// `vec3(power(x.x, y.x), …)`.
bool calls_the_one_of_reals(Helper helper) {
  const std::string call = "(" + std::string(entry(helper).name) + "(";
  return text_of_triples(helper).find(call) != std::string_view::npos;
}

}  // namespace

std::string_view helper_name(Helper helper) {
  return entry(helper).name;
}

bool is_helper_name(std::string_view name) {
  return std::ranges::any_of(kHelpers, [&](const HelperEntry& helper) { return helper.name == name; });
}

std::string print_helpers(const std::set<HelperUse>& helpers) {
  std::set<HelperUse> needed = helpers;
  for (const auto& [helper, of_triples] : helpers) {
    if (of_triples && calls_the_one_of_reals(helper)) needed.insert({helper});
  }
  std::string out;
  for (const auto& [helper, of_triples] : needed) {
    out += of_triples ? text_of_triples(helper) : entry(helper).text;
    out += '\n';
  }
  return out;
}

}  // namespace texbrdf::emit

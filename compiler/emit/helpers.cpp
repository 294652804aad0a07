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
#include "emit/helpers.def"
#undef HELPER
});

const HelperEntry& entry(Helper helper) {
  return kHelpers[static_cast<std::size_t>(helper)];
}

}  // namespace

std::string_view helper_name(Helper helper) {
  return entry(helper).name;
}

bool is_helper_name(std::string_view name) {
  return std::ranges::any_of(kHelpers, [&](const HelperEntry& helper) { return helper.name == name; });
}

std::string print_helpers(const std::set<Helper>& helpers) {
  std::string out;
  for (Helper helper : helpers) {
    out += entry(helper).text;
    out += '\n';
  }
  return out;
}

}  // namespace texbrdf::emit

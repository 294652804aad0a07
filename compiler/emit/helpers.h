#pragma once

#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace texbrdf::emit {

/// Functions that generated code defines where it needs them, from helpers.def.
enum class Helper : uint8_t {
#define HELPER(id, name, text) id,
#define HELPER_OF_TRIPLES(id, text)
#include "emit/helpers.def"
#undef HELPER
#undef HELPER_OF_TRIPLES
};

struct HelperUse {
  Helper helper;
  bool of_triples = false;
  friend auto operator<=>(const HelperUse&, const HelperUse&) = default;
};

std::string_view helper_name(Helper helper);
bool is_helper_name(std::string_view name);
/// Their definitions and those of what they call, each followed by an empty line.
std::string print_helpers(const std::set<HelperUse>& helpers);

}  // namespace texbrdf::emit

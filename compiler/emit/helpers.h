#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace texbrdf::emit {

/// Functions that generated code defines where it needs them, from helpers.def.
enum class Helper : uint8_t {
#define HELPER(id, name, text) id,
#include "emit/helpers.def"
#undef HELPER
};

std::string_view helper_name(Helper helper);
bool is_helper_name(std::string_view name);
/// Their definitions, each followed by an empty line.
std::string print_helpers(const std::set<Helper>& helpers);

}  // namespace texbrdf::emit

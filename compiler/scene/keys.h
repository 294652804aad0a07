#pragma once

#include <span>
#include <string_view>

namespace texbrdf::scene {

/// What keys of KeyBinding may be called, in the order of keys.def.
std::span<const std::string_view> key_names();
bool is_key_name(std::string_view name);

}  // namespace texbrdf::scene

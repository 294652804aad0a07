#pragma once

#include <span>
#include <string>
#include <string_view>

namespace texbrdf::features {

/// `g(${1:x}, ${2:\\omega_i})`: a call whose arguments are filled in one after the other.
std::string call_snippet(std::string_view name, std::span<const std::string_view> parameters);
/// `\\frac{$1}{$2}` of `\frac` and `{#}{#}`.
std::string command_snippet(std::string_view spelling, std::string_view tail);
/// `\frac{…}{…}` of the same.
std::string command_label(std::string_view spelling, std::string_view tail);

/// What a client has to compare with what is typed, where the label does not start with that: what is typed, and how
/// the label goes on behind `key`, the search key of `typed`. Empty where the label will do.
std::string filter_text(std::string_view label, std::string_view typed, std::string_view key);

}  // namespace texbrdf::features

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// A value of JSON takes up to a hundred bytes in memory; more values than this are refused.
inline constexpr uint32_t kMaxJsonValues = 4'000'000;
inline constexpr uint32_t kMaxJsonDepth = 200;

/// Why the text holds too much to be parsed, judged by its brackets and commas; nothing where it does not.
std::optional<std::string> exceeds_json_limits(std::string_view text);

/// With each `\uD800`…`\uDFFF` that is not half of a pair replaced by `\uFFFD`.
std::string without_lone_surrogates(std::string_view text);

}  // namespace texbrdf::lsp

#pragma once

#include <cstdint>
#include <string_view>

namespace texbrdf {

/// What words between a value and its condition say.
enum class RemarkKind : uint8_t {
  Unknown,       ///< nothing that is understood
  Nothing,       ///< there are no words, or an aside in parentheses
  Introduction,  ///< "if", "for all", "else if": a condition follows
  Otherwise,     ///< "otherwise", "else": where no other condition holds
  And,
  Or,
};

/// Of `\text{ if }`, `otherwise`, or a part of a `\text{if $x>0$}`.
RemarkKind read_remark(std::string_view source);
/// Not only spaces and punctuation.
bool holds_words(std::string_view source);
/// "if", "when", "for …": what follows restricts what stands before it.
bool starts_condition(std::string_view source);
/// A word that is a remark in a row of cases even without a `\text` around it.
bool is_bare_remark(std::string_view word);

}  // namespace texbrdf

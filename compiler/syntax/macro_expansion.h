#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "syntax/block_scanner.h"
#include "syntax/macro_table.h"

namespace texbrdf {

/// A macro in the source of a block. Spans are relative to that.
struct MacroUse {
  std::string name;  ///< without the backslash
  Span command;      ///< `\x`
  Span whole;        ///< with its arguments
  friend bool operator==(const MacroUse&, const MacroUse&) = default;
};

/// Why a macro could not be expanded. A character that no equation holds stands in its place.
struct MacroProblem {
  Code code;
  uint32_t at = 0;  ///< where that character stands, in the expanded text
  std::vector<std::string> arguments;
  friend bool operator==(const MacroProblem&, const MacroProblem&) = default;
};

/// The text of a block in which every macro is replaced by what it stands for, and where each byte of it comes from.
/// "Expanded" places are relative to that text, "source" places to the block as it is written.
class MacroExpansion {
 public:
  static constexpr uint32_t kNoUse = UINT32_MAX;
  /// A stretch of the expanded text, up to the next one.
  struct Run {
    uint32_t begin = 0;
    Span source;              ///< what it is copied from; of what macros made, the use
    bool is_written = false;  ///< it is a copy, byte for byte
    bool is_bare = false;     ///< a copy of an argument without braces
    uint32_t top = kNoUse;    ///< the outermost use that it belongs to, of `tops_`
    friend bool operator==(const Run&, const Run&) = default;
  };

  const std::string& text() const { return text_; }
  const BlockExtent& extent() const { return extent_; }
  const std::string& source() const { return source_; }
  const BlockExtent& source_extent() const { return source_extent_; }
  const std::vector<MacroUse>& uses() const { return uses_; }
  /// It holds definitions of macros.
  bool has_definitions() const { return has_definitions_; }

  /// What a reader sees where an expanded stretch comes from.
  Span in_source(Span expanded) const;
  /// The source holds this very text there.
  bool is_written(Span expanded) const;
  /// And another text can stand in its place.
  bool is_replaceable(Span expanded) const;
  /// Where a byte of the source went first; nothing for what was replaced.
  std::optional<uint32_t> from_source(uint32_t offset) const;
  /// The use whose macro made all of the stretch; nullptr where there is none.
  const MacroUse* maker_of(Span expanded) const;
  /// The innermost use whose `\x` the offset touches.
  const MacroUse* use_at(uint32_t source_offset) const;
  /// What is wrong where the character stands; nullptr where nothing is.
  const MacroProblem* problem_at(uint32_t expanded) const;

  /// Of one source: all that can be said of the two is the same.
  bool stands_for_same(const MacroExpansion& other) const;

 private:
  friend class MacroExpander;
  size_t run_of(uint32_t expanded) const;
  uint32_t end_of(size_t run) const;
  bool is_one_copy(Span expanded) const;

  std::string source_;
  BlockExtent source_extent_;
  std::string text_;
  BlockExtent extent_;
  std::vector<Run> runs_;
  std::vector<Span> tops_;      // in the source, of the uses that stand in no argument
  std::vector<MacroUse> uses_;  // in order of `whole`
  std::vector<MacroProblem> problems_;
  bool has_definitions_ = false;
};

/// nullptr where the block uses and defines no macro: its text is what it is.
std::shared_ptr<const MacroExpansion> expand_macros(std::string_view text, const BlockExtent& extent,
                                                    const MacroTable& macros);

}  // namespace texbrdf

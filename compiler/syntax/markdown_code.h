#pragma once

#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

#include "syntax/next_character.h"

namespace texbrdf {

/// Fenced code, inline code and HTML comments of Markdown. They hold no mathematics, but for fences that say `math`.
class MarkdownCode {
 public:
  /// `starts_line`: nothing stands before the text in its line.
  MarkdownCode(std::string_view text, bool starts_line)
      : text_(text), starts_line_(starts_line), backtick_(text, '`'), tilde_(text, '~'), less_(text, '<') {}

  struct Stretch {
    size_t end = 0;         ///< behind it; behind the opener where that opens nothing
    size_t decided_at = 0;  ///< nothing from here on was looked at
    bool is_comment = false;
    bool is_mathematics = false;
    size_t content_begin = 0;  ///< of mathematics
    size_t content_end = 0;
    bool is_closed = false;
  };

  /// The next character that may open one; the text's size where there is none.
  size_t next(size_t at);
  Stretch read(size_t opener);

  /// Behind the `-->`, else the end of the text.
  size_t comment_end(size_t opener) const;

 private:
  struct Fence {
    char character = 0;
    size_t size = 0;  ///< 0: there is none
    size_t line_end = 0;
    bool is_mathematics = false;
  };

  bool is_first_in_line(size_t at) const;
  Fence fence_at(size_t opener) const;
  Stretch read_fence(const Fence& fence) const;
  Stretch read_inline_code(size_t opener);
  /// Notes all runs of backticks from there to the end of the paragraph.
  void read_paragraph(size_t begin);

  size_t run_end(size_t begin) const;
  size_t line_end(size_t from) const;
  size_t behind_line_end(size_t at) const;
  size_t behind_spaces(size_t at) const;

  std::string_view text_;
  bool starts_line_;
  NextCharacter backtick_;
  NextCharacter tilde_;
  NextCharacter less_;
  size_t paragraph_begin_ = 0;
  size_t paragraph_end_ = 0;
  std::map<size_t, std::vector<size_t>> runs_;  // of backticks in the paragraph, by their sizes
};

}  // namespace texbrdf

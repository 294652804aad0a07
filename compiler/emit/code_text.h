#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

#include "emit/emit.h"

namespace texbrdf::emit {

/// Generated code while it is written.
class CodeText {
 public:
  void append(std::string_view text);
  /// Behind a whole line.
  void append(const CodeText& code);
  /// Of the name.
  void append_line(std::string_view line, NameId name) {
    append(line);
    note_lines(name, line_count_ - 1);
  }
  /// The name has the lines from `first` to the last whole one.
  void note_lines(NameId name, uint32_t first) { code_.lines.push_back({name, first, line_count_ - 1}); }

  uint32_t line_count() const { return line_count_; }
  EmittedCode take() { return std::move(code_); }

 private:
  EmittedCode code_;
  uint32_t line_count_ = 0;  ///< whole ones
};

}  // namespace texbrdf::emit

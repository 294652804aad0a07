#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "source/span.h"

namespace texbrdf {

/// How the columns of a position are counted.
enum class ColumnUnit : uint8_t { Utf8, Utf16, CodePoint };

/// Line and column, both from 0. A line ends at "\n", "\r\n" or a lone "\r".
struct Position {
  uint32_t line = 0;
  uint32_t column = 0;
  friend constexpr auto operator<=>(const Position&, const Position&) = default;
};

/// The bytes of one document and where its lines start. Any bytes are accepted: a byte that is not part of
/// well-formed UTF-8 counts as one code point (one UTF-16 unit), so every offset has a position.
/// At most 2 GiB; offsets are 32 bits wide.
class SourceText {
 public:
  static constexpr uint32_t kMaxBytes = uint32_t{1} << 31;

  SourceText() : SourceText(std::string{}) {}
  /// Bytes beyond kMaxBytes are cut off; callers report that before.
  explicit SourceText(std::string bytes);

  std::string_view bytes() const { return bytes_; }
  std::string_view slice(Span span) const;
  uint32_t size() const { return static_cast<uint32_t>(bytes_.size()); }
  uint32_t line_count() const { return static_cast<uint32_t>(line_starts_.size()); }
  /// The line without its line ending. Empty beyond the last line.
  std::string_view line(uint32_t line) const;
  uint32_t line_start(uint32_t line) const { return line_starts_[line]; }

  /// Offsets beyond the end give the end of the document.
  Position position(uint32_t offset, ColumnUnit unit) const;
  /// A column beyond the end of its line gives the line's end, a line beyond the last the document's end;
  /// a column inside a code point gives the code point's start.
  uint32_t offset(Position position, ColumnUnit unit) const;

 private:
  std::string bytes_;
  std::vector<uint32_t> line_starts_;
};

}  // namespace texbrdf

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "source/sequence.h"
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

/// About a thousand bytes of a text. Cut neither inside a code point nor between "\r" and "\n".
class TextChunk {
 public:
  struct Measure {
    uint32_t bytes = 0;
    uint32_t line_ends = 0;
    uint32_t utf16 = 0;
    uint32_t code_points = 0;
    friend Measure operator+(const Measure& a, const Measure& b) {
      return {a.bytes + b.bytes, a.line_ends + b.line_ends, a.utf16 + b.utf16, a.code_points + b.code_points};
    }
    uint32_t columns(ColumnUnit unit) const;
  };

  explicit TextChunk(std::string_view bytes);

  const Measure& measure() const { return measure_; }
  std::string_view bytes() const { return content_->bytes; }
  /// Where lines start, relative to the chunk; never 0.
  const std::vector<uint16_t>& line_starts() const { return content_->line_starts; }
  /// Columns of the whole code points in front of the byte.
  uint32_t columns_before(uint32_t byte, ColumnUnit unit) const;
  /// Bytes of the whole code points that take at most so many columns.
  uint32_t bytes_of(uint32_t columns, ColumnUnit unit) const;

 private:
  struct Content {
    std::string bytes;
    std::vector<uint16_t> line_starts;
  };
  bool is_ascii() const { return measure_.code_points == measure_.bytes; }

  std::shared_ptr<const Content> content_;
  Measure measure_;
};

/// The bytes of one document and where its lines start. Any bytes are accepted: a byte that is not part of
/// well-formed UTF-8 counts as one code point (one UTF-16 unit), so every offset has a position.
/// At most 2 GiB; offsets are 32 bits wide. Immutable; copies share what they have in common, and a text with a few
/// bytes replaced costs O(log size).
class SourceText {
 public:
  static constexpr uint32_t kMaxBytes = uint32_t{1} << 31;

  SourceText() = default;
  /// Bytes beyond kMaxBytes are cut off; callers report that before.
  explicit SourceText(std::string_view bytes);

  /// The text with other bytes in the place of `span`, which has to lie in it.
  SourceText with(Span span, std::string_view replacement) const;

  uint32_t size() const { return chunks_.measure().bytes; }
  std::string bytes() const { return slice({0, size()}); }
  std::string slice(Span span) const;
  uint32_t line_count() const { return chunks_.measure().line_ends + 1; }
  /// The line without its line ending. Empty beyond the last line.
  std::string line(uint32_t line) const;
  /// Of a line that exists.
  uint32_t line_start(uint32_t line) const;

  const Sequence<TextChunk>& chunks() const { return chunks_; }
  /// Offsets beyond the end give the end of the document.
  Position position(uint32_t offset, ColumnUnit unit) const;
  /// Columns of all that stands in front of the offset, line endings included.
  uint32_t columns_before(uint32_t offset, ColumnUnit unit) const;
  /// A column beyond the end of its line gives the line's end, a line beyond the last the document's end;
  /// a column inside a code point gives the code point's start.
  uint32_t offset(Position position, ColumnUnit unit) const;

 private:
  /// Behind the line's last byte that is not of its line ending.
  uint32_t line_end(uint32_t line) const;

  Sequence<TextChunk> chunks_;
};

}  // namespace texbrdf

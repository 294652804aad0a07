#pragma once

#include <compare>
#include <cstdint>

namespace texbrdf {

/// Half-open range of bytes. Relative to the start of its block everywhere in the compiler;
/// Snapshot turns it into an absolute range of the document.
struct Span {
  uint32_t begin = 0;
  uint32_t end = 0;

  constexpr uint32_t size() const { return end - begin; }
  constexpr bool empty() const { return begin == end; }
  /// True for offsets inside and for the one just behind, where a caret still touches the span.
  constexpr bool touches(uint32_t offset) const { return begin <= offset && offset <= end; }
  friend constexpr auto operator<=>(const Span&, const Span&) = default;
};

constexpr Span join(Span first, Span last) {
  return {first.begin, last.end};
}

/// A file of a Project; 0 is the first. A lone document is file 0.
struct FileId {
  uint32_t value = 0;
  friend constexpr auto operator<=>(const FileId&, const FileId&) = default;
};

/// A block of one Snapshot, in document order.
struct BlockId {
  uint32_t value = 0;
  friend constexpr auto operator<=>(const BlockId&, const BlockId&) = default;
};

/// A place that survives edits elsewhere: the span is relative to the block.
struct Location {
  FileId file;
  BlockId block;
  Span span;
  friend constexpr auto operator<=>(const Location&, const Location&) = default;
};

}  // namespace texbrdf

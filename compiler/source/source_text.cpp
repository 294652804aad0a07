#include "source/source_text.h"

#include <algorithm>

#include "source/position_walk.h"
#include "source/utf8.h"

namespace texbrdf {
namespace {

constexpr size_t kChunkBytes = 1024;
// A code point has at most four bytes: whether a cut is right depends on three on either side.
constexpr uint32_t kCutContext = 4;

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

/// True where no code point and no line ending would be cut in two.
bool can_cut(std::string_view text, size_t at) {
  if (text[at - 1] == '\r' && text[at] == '\n') return false;
  if (!is_continuation(text[at])) return true;
  for (size_t back = 1; back < kCutContext && back <= at; ++back) {
    if (!is_continuation(text[at - back])) return code_point_at_front(text.substr(at - back)).size <= back;
  }
  return true;
}

std::vector<TextChunk> cut(std::string_view text) {
  std::vector<TextChunk> chunks;
  chunks.reserve(text.size() / kChunkBytes + 1);
  while (!text.empty()) {
    size_t size = std::min(text.size(), kChunkBytes);
    // What is left is not cut where it would leave next to nothing.
    if (text.size() < kChunkBytes + kChunkBytes / 2) size = text.size();
    while (size < text.size() && !can_cut(text, size)) --size;
    chunks.emplace_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return chunks;
}

}  // namespace

SourceText::SourceText(std::string_view bytes)
    : chunks_(std::span<const TextChunk>(cut(bytes.substr(0, std::min<size_t>(bytes.size(), kMaxBytes))))) {}

SourceText SourceText::with(Span span, std::string_view replacement) const {
  const uint32_t context_begin = span.begin - std::min(span.begin, kCutContext);
  const uint32_t context_end = span.end + std::min(size() - span.end, kCutContext);
  const auto first = chunks_.find([&](const TextChunk::Measure& sum) { return sum.bytes >= context_begin; });
  auto last = chunks_.find([&](const TextChunk::Measure& sum) { return sum.bytes > context_end; });
  const uint32_t end = last.item != nullptr ? last.index + 1 : chunks_.size();
  const uint32_t end_bytes = last.item != nullptr ? last.before.bytes + last.item->measure().bytes : size();

  std::string text = slice({first.before.bytes, span.begin});
  text.append(replacement).append(slice({span.end, end_bytes}));
  SourceText changed;
  changed.chunks_ = chunks_.with(first.index, end - first.index, cut(text));
  return changed;
}

std::string SourceText::slice(Span span) const {
  const uint32_t begin = std::min(span.begin, size());
  const uint32_t end = std::clamp(span.end, begin, size());
  std::string text;
  text.reserve(end - begin);
  const auto first = chunks_.find([&](const TextChunk::Measure& sum) { return sum.bytes > begin; });
  chunks_.visit_from(first.index, [&](const TextChunk& chunk, const TextChunk::Measure& before) {
    if (before.bytes >= end) return false;
    const uint32_t from = std::max(begin, before.bytes) - before.bytes;
    text += chunk.bytes().substr(from, end - before.bytes - from);
    return true;
  });
  return text;
}

uint32_t SourceText::line_start(uint32_t line) const {
  if (line == 0) return 0;
  const auto chunk = chunks_.find([&](const TextChunk::Measure& sum) { return sum.line_ends >= line; });
  return chunk.before.bytes + chunk.item->line_starts()[line - chunk.before.line_ends - 1];
}

uint32_t SourceText::line_end(uint32_t line) const {
  if (line + 1 >= line_count()) return size();
  const uint32_t next = line_start(line + 1);
  const std::string ending = slice({next - std::min(next, 2u), next});
  return next - (ending == "\r\n" ? 2 : 1);
}

std::string SourceText::line(uint32_t line) const {
  if (line >= line_count()) return {};
  return slice({line_start(line), line_end(line)});
}

uint32_t SourceText::columns_before(uint32_t offset, ColumnUnit unit) const {
  const auto chunk = chunks_.find([&](const TextChunk::Measure& sum) { return sum.bytes > offset; });
  if (chunk.item == nullptr) return chunks_.measure().columns(unit);
  return chunk.before.columns(unit) + chunk.item->columns_before(offset - chunk.before.bytes, unit);
}

Position SourceText::position(uint32_t offset, ColumnUnit unit) const {
  return PositionWalk(*this, unit).at(offset);
}

uint32_t SourceText::offset(Position position, ColumnUnit unit) const {
  if (position.line >= line_count()) return size();
  const uint32_t end = line_end(position.line);
  const uint64_t columns = uint64_t{columns_before(line_start(position.line), unit)} + position.column;
  const auto chunk = chunks_.find([&](const TextChunk::Measure& sum) { return sum.columns(unit) > columns; });
  if (chunk.item == nullptr) return end;
  const auto in_chunk = static_cast<uint32_t>(columns - chunk.before.columns(unit));
  return std::min(end, chunk.before.bytes + chunk.item->bytes_of(in_chunk, unit));
}

}  // namespace texbrdf

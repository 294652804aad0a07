#include "syntax/markdown_code.h"

#include <algorithm>

#include "source/characters.h"
#include "source/trimmed.h"

namespace texbrdf {
namespace {

constexpr size_t kShortestFence = 3;
constexpr size_t kDeepestFence = 3;
constexpr std::string_view kCommentOpener = "<!--";
constexpr std::string_view kCommentCloser = "-->";

}  // namespace

size_t MarkdownCode::next(size_t at) {
  return std::min({backtick_.from(at), tilde_.from(at), less_.from(at)});
}

MarkdownCode::Stretch MarkdownCode::read(size_t opener) {
  if (text_[opener] == '<') {
    const std::string_view word = text_.substr(opener, kCommentOpener.size());
    const size_t looked_at = opener + word.size();
    if (word != kCommentOpener) return {.end = opener + 1, .decided_at = looked_at};
    const size_t end = comment_end(opener);
    return {.end = end, .decided_at = end, .is_comment = true};
  }
  if (is_first_in_line(opener)) {
    if (const Fence fence = fence_at(opener); fence.size > 0) return read_fence(fence);
  }
  if (text_[opener] == '`') return read_inline_code(opener);
  const size_t end = run_end(opener);
  return {.end = end, .decided_at = std::min(end + 1, text_.size())};
}

size_t MarkdownCode::comment_end(size_t opener) const {
  const size_t closer = text_.find(kCommentCloser, opener + kCommentOpener.size());
  return closer == std::string_view::npos ? text_.size() : closer + kCommentCloser.size();
}

bool MarkdownCode::is_first_in_line(size_t at) const {
  size_t line = at;
  while (line > 0 && at - line < kDeepestFence && text_[line - 1] == ' ') --line;
  return line == 0 ? starts_line_ : is_line_end(text_[line - 1]);
}

/// A line of three backticks and more of them behind is inline code.
MarkdownCode::Fence MarkdownCode::fence_at(size_t opener) const {
  if (opener >= text_.size() || (text_[opener] != '`' && text_[opener] != '~')) return {};
  const size_t behind = run_end(opener);
  if (behind - opener < kShortestFence) return {};
  const size_t end = line_end(behind);
  const bool is_code = text_[opener] == '`' && text_.substr(behind, end - behind).find('`') != std::string_view::npos;
  if (is_code) return {};
  const bool is_mathematics = text_[opener] == '`' && trimmed(text_.substr(behind, end - behind)) == "math";
  return {text_[opener], behind - opener, end, is_mathematics};
}

MarkdownCode::Stretch MarkdownCode::read_fence(const Fence& fence) const {
  const size_t content_begin = behind_line_end(fence.line_end);
  Stretch stretch{.end = text_.size(),
                  .decided_at = text_.size(),
                  .is_mathematics = fence.is_mathematics,
                  .content_begin = content_begin,
                  .content_end = text_.size()};
  for (size_t line = content_begin; line < text_.size();) {
    const size_t begin = behind_spaces(line);
    const size_t behind = begin < text_.size() && text_[begin] == fence.character ? run_end(begin) : begin;
    const size_t end = line_end(behind);
    const bool holds_nothing_else = std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(behind),
                                                text_.begin() + static_cast<std::ptrdiff_t>(end), is_blank);
    if (behind - begin >= fence.size && holds_nothing_else) {
      stretch.end = end;
      stretch.decided_at = behind_line_end(end);
      stretch.content_end = line;
      stretch.is_closed = true;
      return stretch;
    }
    line = behind_line_end(end);
  }
  return stretch;
}

/// As many backticks close it, in the same paragraph; else those that open it are text.
MarkdownCode::Stretch MarkdownCode::read_inline_code(size_t opener) {
  if (opener < paragraph_begin_ || opener >= paragraph_end_) read_paragraph(opener);
  const size_t behind = run_end(opener);
  const std::vector<size_t>& same = runs_[behind - opener];
  const auto closer = std::ranges::upper_bound(same, opener);
  return {.end = closer == same.end() ? behind : *closer + (behind - opener), .decided_at = paragraph_end_};
}

void MarkdownCode::read_paragraph(size_t begin) {
  runs_.clear();
  paragraph_begin_ = begin;
  for (size_t at = begin; at < text_.size();) {
    const char c = text_[at];
    if (c == '`') {
      const size_t behind = run_end(at);
      runs_[behind - at].push_back(at);
      at = behind;
      continue;
    }
    at = is_line_end(c) ? behind_line_end(at) : at + 1;
    if (!is_line_end(c)) continue;
    const size_t first = behind_spaces(at);
    const size_t end = line_end(first);
    const bool is_blank_line = std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(first),
                                           text_.begin() + static_cast<std::ptrdiff_t>(end), is_blank);
    if (is_blank_line || fence_at(first).size > 0) {
      paragraph_end_ = std::min(behind_line_end(end), text_.size());
      return;
    }
  }
  paragraph_end_ = text_.size();
}

size_t MarkdownCode::run_end(size_t begin) const {
  size_t end = begin;
  while (end < text_.size() && text_[end] == text_[begin]) ++end;
  return end;
}

size_t MarkdownCode::line_end(size_t from) const {
  size_t at = from;
  while (at < text_.size() && !is_line_end(text_[at])) ++at;
  return at;
}

size_t MarkdownCode::behind_line_end(size_t at) const {
  if (text_.substr(at).starts_with("\r\n")) return at + 2;
  return std::min(at + 1, text_.size());
}

/// At most three: what is indented farther is no fence.
size_t MarkdownCode::behind_spaces(size_t at) const {
  size_t behind = at;
  while (behind < text_.size() && behind - at < kDeepestFence && text_[behind] == ' ') ++behind;
  return behind;
}

}  // namespace texbrdf

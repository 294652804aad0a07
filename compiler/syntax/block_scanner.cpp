#include "syntax/block_scanner.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>

namespace texbrdf {
namespace {

/// No name of an environment that matters here is longer; a `{` far from its `}` is no environment.
constexpr size_t kLongestEnvironmentName = 64;

constexpr std::array<std::string_view, 2> kEquations = {"equation", "equation*"};
constexpr std::array<std::string_view, 4> kRawEnvironments = {"verbatim", "verbatim*", "lstlisting", "comment"};

template <size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// The next place of one character. No stretch of the text is searched twice, however far the wanted one is.
class NextCharacter {
 public:
  NextCharacter(std::string_view text, char wanted) : text_(text), wanted_(wanted), known_(find(0, text.size())) {}

  size_t from(size_t at) {
    if (known_ < at) known_ = find(at, text_.size());
    if (at < searched_from_) {
      const size_t earlier = find(at, searched_from_);
      if (earlier != searched_from_) known_ = earlier;
    }
    searched_from_ = at;
    return known_;
  }

 private:
  size_t find(size_t begin, size_t end) const {
    if (begin >= end) return end;
    const void* found = std::memchr(text_.data() + begin, wanted_, end - begin);
    return found == nullptr ? end : static_cast<size_t>(static_cast<const char*>(found) - text_.data());
  }

  std::string_view text_;
  char wanted_;
  size_t known_;
  size_t searched_from_ = 0;
};

/// A `\begin{…}` or `\end{…}` that is no comment and no verbatim text.
struct Mark {
  enum class Kind : uint8_t { Begin, End, DocumentEnd };
  Kind kind = Kind::DocumentEnd;
  Span span;
  std::string_view environment;
};

/// Walks a document from mark to mark.
class MarkReader {
 public:
  explicit MarkReader(std::string_view text) : text_(text), backslash_(text, '\\'), percent_(text, '%') {}

  void seek(size_t at) { at_ = at; }

  Mark next() {
    for (;;) {
      const size_t backslash = backslash_.from(at_);
      const size_t percent = percent_.from(at_);
      if (backslash == percent) break;  // both at the end
      if (percent < backslash) {
        at_ = line_end(percent);
      } else if (const std::optional<Mark> mark = read_command(backslash)) {
        return *mark;
      }
    }
    at_ = text_.size();
    return {Mark::Kind::DocumentEnd, span(at_, at_), {}};
  }

 private:
  static Span span(size_t begin, size_t end) { return {static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}; }

  size_t line_end(size_t from) const {
    return static_cast<size_t>(
        std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(from), text_.end(), is_line_end) - text_.begin());
  }

  std::optional<Mark> read_command(size_t backslash) {
    at_ = backslash + 1;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(backslash + 1, at_ - backslash - 1);
    if (word.empty()) {
      at_ = std::min(at_ + 1, text_.size());
    } else if (word == "begin") {
      return read_begin(backslash);
    } else if (word == "end") {
      return read_end(backslash);
    } else if (word == "verb") {
      skip_verb();
    }
    return std::nullopt;
  }

  std::optional<Mark> read_begin(size_t backslash) {
    const std::string_view environment = read_environment_name();
    if (environment.empty()) return std::nullopt;
    if (is_one_of(environment, kRawEnvironments)) {
      skip_raw(environment);
      return std::nullopt;
    }
    return Mark{Mark::Kind::Begin, span(backslash, at_), environment};
  }

  std::optional<Mark> read_end(size_t backslash) {
    const std::string_view environment = read_environment_name();
    if (environment.empty()) return std::nullopt;
    const bool document = environment == "document";
    return Mark{document ? Mark::Kind::DocumentEnd : Mark::Kind::End, span(backslash, at_), environment};
  }

  /// Reads `{name}`; empty, and nothing is consumed, where there is none.
  std::string_view read_environment_name() {
    size_t open = at_;
    while (open < text_.size() && (text_[open] == ' ' || text_[open] == '\t')) ++open;
    if (open >= text_.size() || text_[open] != '{') return {};
    const std::string_view rest = text_.substr(open + 1, kLongestEnvironmentName);
    const size_t size = rest.find_first_of("}{\\%\r\n");
    if (size == std::string_view::npos || rest[size] != '}') return {};
    at_ = open + size + 2;
    return rest.substr(0, size);
  }

  void skip_raw(std::string_view environment) {
    std::string end = "\\end{";
    end += environment;
    end += '}';
    const size_t found = text_.find(end, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  /// `\verb|…|` and `\verb*|…|`, on one line.
  void skip_verb() {
    if (at_ < text_.size() && text_[at_] == '*') ++at_;
    if (at_ >= text_.size() || is_line_end(text_[at_])) return;
    const char delimiter = text_[at_++];
    while (at_ < text_.size() && text_[at_] != delimiter && !is_line_end(text_[at_])) ++at_;
    if (at_ < text_.size() && text_[at_] == delimiter) ++at_;
  }

  std::string_view text_;
  size_t at_ = 0;
  NextCharacter backslash_;
  NextCharacter percent_;
};

/// Where the first line in [begin, end) starts that holds nothing but spaces.
std::optional<uint32_t> find_blank_line(std::string_view text, uint32_t begin, uint32_t end) {
  bool at_line_start = false;
  uint32_t line_start = begin;
  for (uint32_t i = begin; i < end; ++i) {
    const char c = text[i];
    if (is_line_end(c)) {
      if (at_line_start) return line_start;
      if (c == '\r' && i + 1 < end && text[i + 1] == '\n') ++i;
      line_start = i + 1;
      at_line_start = true;
    } else if (c != ' ' && c != '\t') {
      at_line_start = false;
    }
  }
  return std::nullopt;
}

struct Terminator {
  BlockEnd kind;
  Mark mark;
};

/// The mark that ends the block: the first `\end` that belongs to no environment inside it, or what forbids one.
Terminator find_terminator(MarkReader& reader, std::string_view environment) {
  for (uint32_t open_inside = 0;;) {
    const Mark mark = reader.next();
    switch (mark.kind) {
      case Mark::Kind::DocumentEnd:
        return {BlockEnd::DocumentEnd, mark};
      case Mark::Kind::Begin:
        if (is_one_of(mark.environment, kEquations)) return {BlockEnd::NextBegin, mark};
        ++open_inside;
        break;
      case Mark::Kind::End:
        if (mark.environment == environment) return {BlockEnd::Closed, mark};
        if (open_inside == 0) return {BlockEnd::WrongEnd, mark};
        --open_inside;
        break;
    }
  }
}

constexpr uint32_t kEndTokenSize = 4;  // `\end`

BlockExtent scan_block(MarkReader& reader, std::string_view document, const Mark& begin) {
  Terminator terminator = find_terminator(reader, begin.environment);
  uint32_t content_end = terminator.mark.span.begin;
  if (terminator.kind != BlockEnd::Closed) {
    if (const auto blank = find_blank_line(document, begin.span.end, content_end)) {
      terminator.kind = BlockEnd::BlankLine;
      content_end = *blank;
    }
  }
  const bool has_end = terminator.kind == BlockEnd::Closed || terminator.kind == BlockEnd::WrongEnd;
  const uint32_t whole_end = has_end ? terminator.mark.span.end : content_end;
  reader.seek(whole_end);

  const uint32_t origin = begin.span.begin;
  const Span content = {begin.span.end - origin, content_end - origin};
  return {.whole = {origin, whole_end},
          .begin = {0, content.begin},
          .content = content,
          .end = {content.end, content.end + (has_end ? kEndTokenSize : 0)},
          .ended_by = terminator.kind};
}

}  // namespace

std::vector<BlockExtent> scan_blocks(std::string_view document) {
  std::vector<BlockExtent> blocks;
  MarkReader reader(document);
  for (Mark mark = reader.next(); mark.kind != Mark::Kind::DocumentEnd; mark = reader.next()) {
    if (mark.kind == Mark::Kind::Begin && is_one_of(mark.environment, kEquations)) {
      blocks.push_back(scan_block(reader, document, mark));
    }
  }
  return blocks;
}

}  // namespace texbrdf

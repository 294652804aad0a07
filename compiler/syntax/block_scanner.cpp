#include "syntax/block_scanner.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "syntax/verbatim.h"

namespace texbrdf {
namespace {

/// No name of an environment that matters here is longer; a `{` far from its `}` is no environment.
constexpr size_t kLongestEnvironmentName = 64;

/// Prose is cut into parts of about so many bytes.
constexpr size_t kProseBytes = 4096;

constexpr std::string_view kDirective = "texbrdf:";
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

struct IncludeWord {
  std::string_view word;
  IncludeCommand::Kind kind;
};
constexpr auto kIncludeWords = std::to_array<IncludeWord>({{"input", IncludeCommand::Kind::Input},
                                                           {"include", IncludeCommand::Kind::Input},
                                                           {"subfile", IncludeCommand::Kind::Subfile},
                                                           {"subfileinclude", IncludeCommand::Kind::Subfile},
                                                           {"import", IncludeCommand::Kind::Import},
                                                           {"includefrom", IncludeCommand::Kind::Import},
                                                           {"inputfrom", IncludeCommand::Kind::Import},
                                                           {"subimport", IncludeCommand::Kind::SubImport},
                                                           {"subincludefrom", IncludeCommand::Kind::SubImport},
                                                           {"subinputfrom", IncludeCommand::Kind::SubImport}});

/// No path that matters here is longer.
constexpr size_t kLongestPath = 1024;

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

/// A `\begin{…}` or `\end{…}` that is no comment and no verbatim text, or the opener of a formula; or a place where
/// prose may be cut.
struct Mark {
  enum class Kind : uint8_t { Begin, End, Formula, DocumentEnd, Cut };
  Kind kind = Kind::DocumentEnd;
  Span span;
  std::string_view environment = {};
  MathRegion region = MathRegion::Environment;  ///< of a formula
  FormulaEnd formula = {};
};

/// Walks a document from mark to mark.
class MarkReader {
 public:
  explicit MarkReader(std::string_view text)
      : text_(text), backslash_(text, '\\'), percent_(text, '%'), dollar_(text, '$') {}

  void seek(size_t at) { at_ = at; }

  /// Stops at the first line that starts behind `cut_from`.
  Mark next_in_prose(size_t cut_from) {
    for (;;) {
      const size_t backslash = backslash_.from(at_);
      const size_t percent = percent_.from(at_);
      const size_t dollar = dollar_.from(at_);
      const size_t nearest = std::min({backslash, percent, dollar});
      if (const size_t cut = find_cut(cut_from, nearest); cut != kNoCut) {
        at_ = cut;
        return {Mark::Kind::Cut, span(cut, cut)};
      }
      if (nearest == text_.size()) return document_end();
      std::optional<Mark> mark;
      if (nearest == percent) {
        read_comment(percent);
      } else if (nearest == dollar) {
        mark = read_formula(dollar, text_.substr(dollar, 2) == "$$" ? MathRegion::DoubleDollars : MathRegion::Dollars);
      } else {
        mark = read_command(backslash, Inside::Prose);
      }
      if (mark) return *mark;
    }
  }

  /// Formulas are no marks there.
  Mark next_in_environment() {
    for (;;) {
      const size_t backslash = backslash_.from(at_);
      const size_t percent = percent_.from(at_);
      if (backslash == percent) return document_end();  // both are there
      if (percent < backslash) {
        read_comment(percent);
      } else if (const std::optional<Mark> mark = read_command(backslash, Inside::Environment)) {
        return *mark;
      }
    }
  }

  /// Comments `% texbrdf:` since they were last taken.
  std::vector<Span> take_directives() { return std::exchange(directives_, {}); }
  /// Absolute, since they were last taken.
  std::vector<IncludeCommand> take_includes() { return std::exchange(includes_, {}); }
  /// Where the lines of comments begin, the first of them a directive, that end right above `mark`; else its begin.
  uint32_t with_directives(const Mark& mark) const {
    return has_run_ && run_end_ == mark.span.begin ? run_begin_ : mark.span.begin;
  }

 private:
  enum class Inside : uint8_t { Prose, Environment };
  static constexpr size_t kNoCut = std::string_view::npos;

  static Span span(size_t begin, size_t end) { return {static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}; }

  size_t find_cut(size_t cut_from, size_t end) const {
    // A directive stays with the block below it.
    const size_t from = std::max({cut_from, at_, size_t{run_end_}});
    if (cut_from == kNoCut || from >= end) return kNoCut;
    const size_t line_feed = text_.substr(0, end).find('\n', from);
    return line_feed == std::string_view::npos ? kNoCut : line_feed + 1;
  }

  Mark document_end() {
    at_ = text_.size();
    return {Mark::Kind::DocumentEnd, span(at_, at_)};
  }

  void read_comment(size_t percent) {
    note_directive(percent);
    at_ = line_end(percent);
  }

  void note_directive(size_t percent) {
    size_t word = percent + 1;
    while (word < text_.size() && is_blank(text_[word])) ++word;
    if (!text_.substr(word).starts_with(kDirective)) return;
    directives_.push_back(span(percent, line_end(percent)));
    if (has_run_ && percent < run_end_) return;
    has_run_ = true;
    run_begin_ = static_cast<uint32_t>(percent);
    run_end_ = static_cast<uint32_t>(behind_comments(percent));
  }

  /// Behind the lines of comments from `percent` on and the blanks that the next line starts with.
  size_t behind_comments(size_t percent) const {
    size_t at = percent;
    while (at < text_.size() && text_[at] == '%') {
      at = line_end(at);
      if (text_.substr(at).starts_with("\r\n")) ++at;
      if (at < text_.size()) ++at;
      while (at < text_.size() && is_blank(text_[at])) ++at;
    }
    return at;
  }

  size_t line_end(size_t from) const {
    return static_cast<size_t>(
        std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(from), text_.end(), is_line_end) - text_.begin());
  }

  /// Inline mathematics that defines nothing is passed over.
  std::optional<Mark> read_formula(size_t opener, MathRegion region) {
    const size_t begin = opener + opener_of(region).size();
    const FormulaEnd end = find_formula_end(text_, static_cast<uint32_t>(begin), region);
    at_ = end.end;
    const bool may_define = end.ended_by == BlockEnd::Closed && end.has_relation;
    if (is_inline(region) && !may_define) return std::nullopt;
    return Mark{.kind = Mark::Kind::Formula, .span = span(opener, begin), .region = region, .formula = end};
  }

  std::optional<Mark> read_command(size_t backslash, Inside inside) {
    at_ = backslash + 1;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(backslash + 1, at_ - backslash - 1);
    if (word.empty()) {
      const char symbol = at_ < text_.size() ? text_[at_] : ' ';
      at_ = std::min(at_ + 1, text_.size());
      if (inside == Inside::Prose && symbol == '[') return read_formula(backslash, MathRegion::Brackets);
      if (inside == Inside::Prose && symbol == '(') return read_formula(backslash, MathRegion::Parentheses);
    } else if (word == "begin") {
      return read_begin(backslash);
    } else if (word == "end") {
      return read_end(backslash);
    } else if (word == "verb") {
      at_ = end_of_verb(text_, at_);
    } else if (const auto include = std::ranges::find(kIncludeWords, word, &IncludeWord::word);
               include != kIncludeWords.end()) {
      read_include(backslash, include->kind);
    }
    return std::nullopt;
  }

  /// A path that holds a command or a parameter of a macro is none that could be read.
  void read_include(size_t backslash, IncludeCommand::Kind kind) {
    IncludeCommand include{.kind = kind, .span = {}, .folder = {}, .path = {}};
    const bool has_folder = kind == IncludeCommand::Kind::Import || kind == IncludeCommand::Kind::SubImport;
    const size_t behind_word = at_;
    if (has_folder) include.folder = read_path();
    if (!has_folder || at_ != behind_word) include.path = read_path();
    if (include.path.empty()) {
      at_ = behind_word;
      return;
    }
    include.span = span(backslash, at_);
    includes_.push_back(include);
  }

  /// What stands in `{…}`, without spaces around; empty, and nothing is consumed, where there is no path.
  Span read_path() {
    size_t open = at_;
    while (open < text_.size() && is_blank(text_[open])) ++open;
    if (open >= text_.size() || text_[open] != '{') return {};
    const std::string_view rest = text_.substr(open + 1, kLongestPath);
    const size_t size = rest.find_first_of("}{\\%#|\r\n");
    if (size == std::string_view::npos || rest[size] != '}') return {};
    size_t begin = open + 1;
    size_t end = begin + size;
    at_ = end + 1;
    while (begin < end && is_blank(text_[begin])) ++begin;
    while (begin < end && is_blank(text_[end - 1])) --end;
    return span(begin, end);
  }

  std::optional<Mark> read_begin(size_t backslash) {
    const std::string_view environment = read_environment_name();
    if (environment.empty()) return std::nullopt;
    if (is_raw_environment(environment)) {
      skip_raw(environment);
      return std::nullopt;
    }
    const MathEnvironment* const known = find_math_environment(environment);
    if (known != nullptr && known->has_argument) read_environment_name();
    return Mark{Mark::Kind::Begin, span(backslash, at_), environment};
  }

  std::optional<Mark> read_end(size_t backslash) {
    const std::string_view environment = read_environment_name();
    if (environment.empty()) return std::nullopt;
    const bool document = environment == "document";
    return Mark{document ? Mark::Kind::DocumentEnd : Mark::Kind::End, span(backslash, at_), environment};
  }

  /// Reads `{name}`, or an argument that is as short; empty, and nothing is consumed, where there is none.
  std::string_view read_environment_name() {
    size_t open = at_;
    while (open < text_.size() && is_blank(text_[open])) ++open;
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

  std::string_view text_;
  size_t at_ = 0;
  NextCharacter backslash_;
  NextCharacter percent_;
  NextCharacter dollar_;
  std::vector<Span> directives_;
  std::vector<IncludeCommand> includes_;
  bool has_run_ = false;
  uint32_t run_begin_ = 0;
  uint32_t run_end_ = 0;
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
    } else if (!is_blank(c)) {
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
    const Mark mark = reader.next_in_environment();
    switch (mark.kind) {
      case Mark::Kind::DocumentEnd:
        return {BlockEnd::DocumentEnd, mark};
      case Mark::Kind::Begin:
        if (is_display_environment(mark.environment)) return {BlockEnd::NextBegin, mark};
        ++open_inside;
        break;
      case Mark::Kind::End:
        if (mark.environment == environment) return {BlockEnd::Closed, mark};
        if (open_inside == 0) return {BlockEnd::WrongEnd, mark};
        --open_inside;
        break;
      case Mark::Kind::Formula:
      case Mark::Kind::Cut:
        break;
    }
  }
}

constexpr uint32_t kEndTokenSize = 4;  // `\end`

DocumentPart block_part(uint32_t origin, const BlockExtent& extent, uint32_t decided_at) {
  return {.begin = origin,
          .size = extent.whole.size(),
          .reach = std::max(decided_at - origin, extent.whole.size()),
          .block = extent,
          .directives = {},
          .includes = {}};
}

DocumentPart scan_environment(MarkReader& reader, std::string_view document, uint32_t origin, const Mark& begin) {
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

  const Span content = {begin.span.end - origin, content_end - origin};
  const BlockExtent extent = {.whole = {origin, whole_end},
                              .begin = {begin.span.begin - origin, content.begin},
                              .content = content,
                              .end = {content.end, content.end + (has_end ? kEndTokenSize : 0)},
                              .ended_by = terminator.kind};
  return block_part(origin, extent, terminator.mark.span.end);
}

DocumentPart formula_part(uint32_t origin, const Mark& mark) {
  const FormulaEnd& end = mark.formula;
  const Span content = {mark.span.end - origin, end.content_end - origin};
  const BlockExtent extent = {.whole = {origin, end.end},
                              .begin = {mark.span.begin - origin, content.begin},
                              .content = content,
                              .end = {content.end, end.end - origin},
                              .ended_by = end.ended_by,
                              .region = mark.region};
  return block_part(origin, extent, end.decided_at);
}

}  // namespace

struct BlockScanner::Impl {
  std::string_view text;
  bool is_whole;
  MarkReader reader;
  uint32_t at = 0;
  std::optional<Mark> found;  // what ended the prose before

  std::optional<DocumentPart> read() {
    if (at == text.size()) return std::nullopt;
    const Mark mark = found ? *std::exchange(found, std::nullopt) : next_mark();
    const bool is_block = mark.kind == Mark::Kind::Begin || mark.kind == Mark::Kind::Formula;
    const uint32_t begin = is_block ? reader.with_directives(mark) : mark.span.begin;
    if (begin > at) {
      if (mark.kind != Mark::Kind::Cut) found = mark;
      return prose(begin, mark);
    }
    if (!is_block) return epilogue(mark);
    DocumentPart part =
        mark.kind == Mark::Kind::Formula ? formula_part(at, mark) : scan_environment(reader, text, at, mark);
    // Those of a block are its own.
    reader.take_directives();
    reader.take_includes();
    return part;
  }

  Mark next_mark() {
    for (;;) {
      const Mark mark = reader.next_in_prose(at + kProseBytes);
      switch (mark.kind) {
        case Mark::Kind::Begin:
          if (is_display_environment(mark.environment)) return mark;
          break;
        case Mark::Kind::End:
          break;
        case Mark::Kind::Formula:
        case Mark::Kind::DocumentEnd:
        case Mark::Kind::Cut:
          return mark;
      }
    }
  }

  DocumentPart prose(uint32_t end, const Mark& behind) {
    // What stands inline is a block or prose by all that it holds.
    const uint32_t decided_at = is_inline(behind.region) ? behind.formula.decided_at : behind.span.end;
    DocumentPart part{
        .begin = at, .size = end - at, .reach = decided_at - at, .block = {}, .directives = {}, .includes = {}};
    for (Span directive : reader.take_directives()) {
      if (directive.begin < end) part.directives.push_back({directive.begin - at, directive.end - at});
    }
    for (IncludeCommand include : reader.take_includes()) {
      if (include.folder.empty()) include.folder = {at, at};
      for (Span* span : {&include.span, &include.folder, &include.path}) *span = {span->begin - at, span->end - at};
      part.includes.push_back(include);
    }
    return part;
  }

  DocumentPart epilogue(const Mark& mark) const {
    return {.begin = at,
            .size = static_cast<uint32_t>(text.size()) - at,
            .reach = mark.span.end - at,
            .block = {},
            .directives = {},
            .includes = {},
            .is_epilogue = true};
  }
};

BlockScanner::BlockScanner(std::string_view text, bool is_whole)
    : impl_(std::make_unique<Impl>(Impl{text, is_whole, MarkReader(text), 0, std::nullopt})) {}
BlockScanner::~BlockScanner() = default;

std::optional<DocumentPart> BlockScanner::next() {
  std::optional<DocumentPart> part = impl_->read();
  if (!part) return std::nullopt;
  const bool depends_on_what_follows = !impl_->is_whole && part->begin + part->reach >= impl_->text.size();
  if (depends_on_what_follows) return std::nullopt;
  impl_->at += part->size;
  // An edit anywhere in the epilogue is one of it.
  if (part->is_epilogue) part->reach = part->size;
  return part;
}

std::vector<DocumentPart> scan_parts(std::string_view document) {
  std::vector<DocumentPart> parts;
  BlockScanner scanner(document, true);
  while (std::optional<DocumentPart> part = scanner.next()) parts.push_back(std::move(*part));
  return parts;
}

std::vector<BlockExtent> scan_blocks(std::string_view document) {
  std::vector<BlockExtent> blocks;
  BlockScanner scanner(document, true);
  while (const std::optional<DocumentPart> part = scanner.next()) {
    if (part->block) blocks.push_back(*part->block);
  }
  return blocks;
}

}  // namespace texbrdf

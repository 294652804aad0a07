#include "syntax/block_scanner.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "source/characters.h"
#include "syntax/markdown_code.h"
#include "syntax/next_character.h"
#include "syntax/verbatim.h"

namespace texbrdf {
namespace {

/// No name of an environment that matters here is longer; a `{` far from its `}` is no environment.
constexpr size_t kLongestEnvironmentName = 64;

/// Prose is cut into parts of about so many bytes.
constexpr size_t kProseBytes = 4096;

constexpr std::string_view kDirective = "texbrdf:";
constexpr std::string_view kHtmlCommentOpener = "<!--";
constexpr std::string_view kHtmlCommentCloser = "-->";

/// A `$` and the next one, with code in backticks between, are two stray ones; those farther apart are not looked at.
constexpr size_t kLongestStray = 1024;

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

/// ` and `: words with blanks around, and nothing that mathematics is written with.
bool is_prose(std::string_view text) {
  if (text.size() < 2 || !is_blank(text.front()) || !is_blank(text.back())) return false;
  bool has_word = false;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 1).find_first_of("\\^_{}+*/<>|") != std::string_view::npos) return false;
    has_word = has_word || (i > 0 && is_letter(text[i]) && is_letter(text[i - 1]));
  }
  return has_word;
}

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
  MarkReader(std::string_view text, TextLanguage language, bool starts_line)
      : text_(text), backslash_(text, '\\'), percent_(text, '%'), dollar_(text, '$') {
    if (language == TextLanguage::Markdown) markdown_.emplace(text, starts_line);
  }

  /// What stands from there on will be read again.
  void seek(size_t at) {
    at_ = at;
    std::erase_if(macros_, [at](const MacroDefinition& macro) { return macro.span.begin >= at; });
  }

  /// Stops at the first line that starts behind `cut_from`.
  Mark next_in_prose(size_t cut_from) {
    for (;;) {
      const size_t backslash = backslash_.from(at_);
      const size_t percent = markdown_ ? text_.size() : percent_.from(at_);
      const size_t code = markdown_ ? markdown_->next(at_) : text_.size();
      const size_t dollar = dollar_.from(at_);
      const size_t nearest = std::min({backslash, percent, code, dollar});
      if (const size_t cut = find_cut(cut_from, nearest); cut != kNoCut) {
        at_ = cut;
        return {Mark::Kind::Cut, span(cut, cut)};
      }
      if (nearest == text_.size()) return document_end();
      std::optional<Mark> mark;
      if (nearest == percent) {
        read_comment(percent);
      } else if (nearest == code) {
        mark = read_code(code);
      } else if (nearest == dollar) {
        mark = read_dollar(dollar);
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

  /// How far was looked to find what is no formula.
  uint32_t decided_at() const { return decided_at_; }

  /// Comments `texbrdf:` since they were last taken.
  std::vector<Span> take_directives() { return std::exchange(directives_, {}); }
  /// Absolute, since they were last taken.
  std::vector<IncludeCommand> take_includes() { return std::exchange(includes_, {}); }
  /// Absolute, since they were last taken: those that begin before `end`.
  std::vector<MacroDefinition> take_macros(uint32_t end) {
    const auto behind =
        std::ranges::partition_point(macros_, [end](const MacroDefinition& m) { return m.span.begin < end; });
    std::vector<MacroDefinition> taken(std::make_move_iterator(macros_.begin()), std::make_move_iterator(behind));
    macros_.erase(macros_.begin(), behind);
    return taken;
  }
  /// No definition of a macro was looked at from here on.
  uint32_t macros_decided_at() const { return macros_decided_at_; }
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

  /// Of Markdown.
  std::optional<Mark> read_code(size_t opener) {
    const MarkdownCode::Stretch stretch = markdown_->read(opener);
    if (stretch.is_comment) note_html_directive(opener);
    at_ = stretch.end;
    decided_at_ = std::max(decided_at_, static_cast<uint32_t>(stretch.decided_at));
    if (!stretch.is_mathematics) return std::nullopt;
    const FormulaEnd end{.ended_by = stretch.is_closed ? BlockEnd::Closed : BlockEnd::DocumentEnd,
                         .content_end = static_cast<uint32_t>(stretch.content_end),
                         .end = static_cast<uint32_t>(stretch.end),
                         .decided_at = static_cast<uint32_t>(stretch.decided_at),
                         .has_relation = true};
    return formula(line_begin(opener), stretch.content_begin, MathRegion::Fence, end);
  }

  /// Of what only blanks stand before.
  size_t line_begin(size_t at) const {
    while (at > 0 && is_blank(text_[at - 1])) --at;
    return at;
  }

  std::optional<Mark> read_dollar(size_t dollar) {
    const std::string_view opener = text_.substr(dollar, 2);
    if (markdown_ && opener == opener_of(MathRegion::BacktickDollars)) {
      const FormulaEnd end =
          find_formula_end(text_, static_cast<uint32_t>(dollar + opener.size()), MathRegion::BacktickDollars);
      decided_at_ = std::max(decided_at_, end.decided_at);
      at_ = end.end;
      if (end.ended_by == BlockEnd::Closed) {
        return formula(dollar, dollar + opener.size(), MathRegion::BacktickDollars, end);
      }
    }
    return read_formula(dollar, opener == "$$" ? MathRegion::DoubleDollars : MathRegion::Dollars);
  }

  void note_directive(size_t percent) {
    if (!says_directive(percent + 1)) return;
    directives_.push_back(span(percent, line_end(percent)));
    if (!is_in_run(percent)) begin_run(percent, behind_comments(percent));
  }

  void note_html_directive(size_t opener) {
    if (!says_directive(opener + kHtmlCommentOpener.size())) return;
    const size_t end = end_in_line(opener);
    if (end == opener) return;
    directives_.push_back(span(opener, end));
    if (!is_in_run(opener)) begin_run(opener, behind_html_comments(opener));
  }

  bool says_directive(size_t word) const {
    while (word < text_.size() && is_blank(text_[word])) ++word;
    return text_.substr(word).starts_with(kDirective);
  }

  bool is_in_run(size_t comment) const { return has_run_ && comment < run_end_; }

  void begin_run(size_t begin, size_t end) {
    has_run_ = true;
    run_begin_ = static_cast<uint32_t>(begin);
    run_end_ = static_cast<uint32_t>(end);
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

  /// The same, of HTML comments that take a line each.
  size_t behind_html_comments(size_t opener) const {
    size_t at = opener;
    for (size_t end = end_in_line(at); end != at; end = end_in_line(at)) {
      at = behind_blanks(end);
      if (at >= text_.size() || !is_line_end(text_[at])) return at;
      if (text_.substr(at).starts_with("\r\n")) ++at;
      at = behind_blanks(at + 1);
    }
    return at;
  }

  /// Of an HTML comment; where it opens if none stands there or another line closes it.
  size_t end_in_line(size_t opener) const {
    if (!text_.substr(opener).starts_with(kHtmlCommentOpener)) return opener;
    for (size_t at = opener + kHtmlCommentOpener.size(); at < text_.size() && !is_line_end(text_[at]); ++at) {
      if (text_.substr(at).starts_with(kHtmlCommentCloser)) return at + kHtmlCommentCloser.size();
    }
    return opener;
  }

  size_t behind_blanks(size_t at) const {
    while (at < text_.size() && is_blank(text_[at])) ++at;
    return at;
  }

  size_t line_end(size_t from) const {
    return static_cast<size_t>(
        std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(from), text_.end(), is_line_end) - text_.begin());
  }

  /// Inline mathematics that defines nothing is passed over; a `$` before words belongs to no formula: the next one may
  /// open one.
  std::optional<Mark> read_formula(size_t opener, MathRegion region) {
    const size_t begin = opener + opener_of(region).size();
    const FormulaEnd end = find_formula_end(text_, static_cast<uint32_t>(begin), region);
    at_ = end.end;
    decided_at_ = std::max(decided_at_, end.decided_at);
    const std::string_view content = text_.substr(begin, end.content_end - begin);
    const bool is_stray = (!end.has_relation && is_prose(content)) || holds_code(content);
    if (region == MathRegion::Dollars && end.ended_by == BlockEnd::Closed && is_stray) {
      at_ = begin;
      return std::nullopt;
    }
    return formula(opener, begin, region, end);
  }

  /// Nothing where it is prose.
  std::optional<Mark> formula(size_t opener, size_t begin, MathRegion region, const FormulaEnd& end) {
    for (MacroDefinition& macro : find_macro_definitions(text_, {static_cast<uint32_t>(begin), end.content_end})) {
      macros_.push_back(std::move(macro));
    }
    const bool may_define = end.ended_by == BlockEnd::Closed && end.has_relation;
    if (is_inline(region) && !may_define) return std::nullopt;
    return Mark{.kind = Mark::Kind::Formula, .span = span(opener, begin), .region = region, .formula = end};
  }

  /// Of Markdown.
  bool holds_code(std::string_view content) const {
    return markdown_ && content.size() <= kLongestStray && content.find('`') != std::string_view::npos;
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
    } else if (defines_macros(word)) {
      read_macro(backslash);
    } else if (const MathShortcut* const shortcut = find_math_shortcut(word);
               shortcut != nullptr && inside == Inside::Prose) {
      return read_shortcut(backslash, *shortcut);
    }
    return std::nullopt;
  }

  /// `\be … \ee`; a command that nothing closes is another macro.
  std::optional<Mark> read_shortcut(size_t backslash, const MathShortcut& shortcut) {
    const size_t begin = at_;
    const FormulaEnd end = find_formula_end(text_, static_cast<uint32_t>(begin), MathRegion::Shortcut, &shortcut);
    decided_at_ = std::max(decided_at_, end.decided_at);
    if (end.ended_by != BlockEnd::Closed) return std::nullopt;
    at_ = end.end;
    return formula(backslash, begin, MathRegion::Shortcut, end);
  }

  /// What a macro stands for is no part of the text around.
  void read_macro(size_t backslash) {
    MacroReading reading = read_macro_definition(text_, static_cast<uint32_t>(backslash), static_cast<uint32_t>(at_));
    macros_decided_at_ = std::max(macros_decided_at_, reading.decided_at);
    if (!reading.definition) return;
    at_ = reading.definition->span.end;
    macros_.push_back(std::move(*reading.definition));
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
  uint32_t decided_at_ = 0;
  NextCharacter backslash_;
  NextCharacter percent_;
  NextCharacter dollar_;
  std::optional<MarkdownCode> markdown_;  // of a text that is Markdown
  std::vector<Span> directives_;
  std::vector<IncludeCommand> includes_;
  std::vector<MacroDefinition> macros_;
  uint32_t macros_decided_at_ = 0;
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
          .includes = {},
          .macros = {}};
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
    add_macros(part);
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
    const uint32_t mark_at = is_inline(behind.region) ? behind.formula.decided_at : behind.span.end;
    const uint32_t decided_at = std::max(mark_at, reader.decided_at());
    DocumentPart part{.begin = at,
                      .size = end - at,
                      .reach = decided_at - at,
                      .block = {},
                      .directives = {},
                      .includes = {},
                      .macros = {}};
    for (Span directive : reader.take_directives()) {
      if (directive.begin < end) part.directives.push_back({directive.begin - at, directive.end - at});
    }
    for (IncludeCommand include : reader.take_includes()) {
      if (include.folder.empty()) include.folder = {at, at};
      for (Span* span : {&include.span, &include.folder, &include.path}) *span = {span->begin - at, span->end - at};
      part.includes.push_back(include);
    }
    add_macros(part);
    return part;
  }

  void add_macros(DocumentPart& part) {
    part.macros = reader.take_macros(part.begin + part.size);
    for (MacroDefinition& macro : part.macros) {
      for (Span* span : {&macro.span, &macro.name_span}) *span = {span->begin - part.begin, span->end - part.begin};
    }
    if (reader.macros_decided_at() > part.begin) {
      part.reach = std::max(part.reach, reader.macros_decided_at() - part.begin);
    }
  }

  DocumentPart epilogue(const Mark& mark) const {
    return {.begin = at,
            .size = static_cast<uint32_t>(text.size()) - at,
            .reach = mark.span.end - at,
            .block = {},
            .directives = {},
            .includes = {},
            .macros = {},
            .is_epilogue = true};
  }
};

BlockScanner::BlockScanner(std::string_view text, bool is_whole, TextLanguage language, bool starts_line)
    : impl_(std::make_unique<Impl>(Impl{text, is_whole, MarkReader(text, language, starts_line), 0, std::nullopt})) {}
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

std::vector<DocumentPart> scan_parts(std::string_view document, TextLanguage language) {
  std::vector<DocumentPart> parts;
  BlockScanner scanner(document, true, language, true);
  while (std::optional<DocumentPart> part = scanner.next()) parts.push_back(std::move(*part));
  return parts;
}

std::vector<BlockExtent> scan_blocks(std::string_view document, TextLanguage language) {
  std::vector<BlockExtent> blocks;
  BlockScanner scanner(document, true, language, true);
  while (const std::optional<DocumentPart> part = scanner.next()) {
    if (part->block) blocks.push_back(*part->block);
  }
  return blocks;
}

}  // namespace texbrdf

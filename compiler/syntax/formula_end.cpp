#include "syntax/formula_end.h"

#include <algorithm>
#include <array>

#include "source/characters.h"
#include "syntax/control_words.h"
#include "syntax/verbatim.h"

namespace texbrdf {
namespace {

/// Words that no formula holds: one that meets them was never closed.
constexpr auto kWordsOfProse =
    std::to_array<std::string_view>({"item", "par", "section", "subsection", "paragraph", "chapter", "caption"});

class FormulaReader {
 public:
  FormulaReader(std::string_view text, uint32_t begin, MathRegion region, const MathShortcut* shortcut)
      : text_(text), region_(region), shortcut_(shortcut), at_(begin) {}

  FormulaEnd run() {
    while (!is_done_ && at_ < text_.size()) read_one();
    if (!is_done_) stop(BlockEnd::DocumentEnd, at_, at_);
    result_.decided_at = std::max(at_, looked_at_);
    return result_;
  }

 private:
  void read_one() {
    switch (text_[at_]) {
      case '\n':
      case '\r':
        return read_line_end();
      case '%':
        while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
        return;
      case '\\':
        return read_command();
      case '$':
        return read_dollar();
      case '`':
        return read_backtick();
      case '{':
        ++depth_;
        break;
      case '}':
        if (depth_ > 0) --depth_;
        if (depth_ < text_depth_) text_depth_ = 0;
        break;
      case '=':
        note_relation();
        break;
      default:
        break;
    }
    ++at_;
  }

  void read_line_end() {
    if (text_.substr(at_).starts_with("\r\n")) ++at_;
    const uint32_t next_line = ++at_;
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (at_ >= text_.size() || !is_line_end(text_[at_])) return;
    ++at_;
    stop(BlockEnd::BlankLine, next_line, next_line);
  }

  void read_backtick() {
    const uint32_t begin = at_++;
    if (region_ != MathRegion::BacktickDollars) return;
    const bool closes = at_ < text_.size() && text_[at_] == '$';
    looked_at_ = std::min(at_ + 1, static_cast<uint32_t>(text_.size()));
    stop(closes ? BlockEnd::Closed : BlockEnd::WrongEnd, begin, closes ? at_ + 1 : at_);
  }

  void read_dollar() {
    const uint32_t begin = at_++;
    if (text_depth_ > 0) return;
    if (region_ == MathRegion::Shortcut) return stop(BlockEnd::WrongEnd, begin, at_);
    if (region_ == MathRegion::Dollars) return stop(BlockEnd::Closed, begin, at_);
    if (region_ != MathRegion::DoubleDollars) return;
    const bool is_double = at_ < text_.size() && text_[at_] == '$';
    if (is_double) ++at_;
    stop(is_double ? BlockEnd::Closed : BlockEnd::WrongEnd, begin, at_);
  }

  void read_command() {
    const uint32_t backslash = at_++;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(backslash + 1, at_ - backslash - 1);
    if (word.empty()) return read_symbol(backslash);
    if (shortcut_ != nullptr && word == shortcut_->closer) return stop(BlockEnd::Closed, backslash, at_);
    if (shortcut_ != nullptr && find_math_shortcut(word) != nullptr) {
      return stop(BlockEnd::NextBegin, backslash, backslash);
    }
    if (word == "verb") {
      at_ = static_cast<uint32_t>(end_of_verb(text_, at_));
    } else if (word == "begin") {
      read_begin(backslash);
    } else if (word == "end") {
      const std::string_view rest = text_.substr(at_, kLongestGroup);
      looked_at_ = at_ + static_cast<uint32_t>(rest.size());
      if (open_environments_ == 0 || rest.starts_with("{document}")) {
        return stop(BlockEnd::NextBegin, backslash, backslash);
      }
      --open_environments_;
    } else if (std::ranges::find(kWordsOfProse, word) != kWordsOfProse.end()) {
      stop(BlockEnd::NextBegin, backslash, backslash);
    } else {
      const ControlWord& known = find_control_word(word);
      if (known.meaning == WordMeaning::Text || known.meaning == WordMeaning::NothingWithGroup) begin_text();
      if (known.kind == TokenKind::Equals) note_relation();
    }
  }

  /// A `$` in `\text{…}` or `\tag{…}` is no end.
  void begin_text() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (text_depth_ == 0 && at_ < text_.size() && text_[at_] == '{') text_depth_ = depth_ + 1;
  }

  /// A backslash and what is no letter.
  void read_symbol(uint32_t backslash) {
    if (at_ >= text_.size()) return;
    const std::string_view symbol = text_.substr(backslash, 2);
    if (is_line_end(symbol[1])) return;
    ++at_;
    if (text_depth_ > 0) return;
    const bool ends_with_symbol = region_ == MathRegion::Brackets || region_ == MathRegion::Parentheses;
    if (ends_with_symbol && symbol == closer_of(region_)) return stop(BlockEnd::Closed, backslash, at_);
    if (symbol == "\\[" || symbol == "\\(") stop(BlockEnd::NextBegin, backslash, backslash);
  }

  /// An equation in `$$` is what MathJax's users write; anywhere else it begins a block of its own.
  void read_begin(uint32_t backslash) {
    const std::string_view rest = text_.substr(at_, kLongestGroup);
    const size_t close = rest.find('}');
    looked_at_ = at_ + static_cast<uint32_t>(std::min(close, rest.size()));
    const std::string_view name =
        rest.starts_with('{') && close != std::string_view::npos ? rest.substr(1, close - 1) : "";
    if (region_ != MathRegion::DoubleDollars && is_display_environment(name)) {
      return stop(BlockEnd::NextBegin, backslash, backslash);
    }
    ++open_environments_;
  }

  void note_relation() {
    if (depth_ == 0) result_.has_relation = true;
  }

  void stop(BlockEnd how, uint32_t content_end, uint32_t end) {
    is_done_ = true;
    result_.ended_by = how;
    result_.content_end = content_end;
    result_.end = end;
    at_ = std::max(at_, end);
  }

  static constexpr size_t kLongestGroup = 66;

  std::string_view text_;
  MathRegion region_;
  const MathShortcut* shortcut_;
  uint32_t at_;
  uint32_t depth_ = 0;
  uint32_t text_depth_ = 0;  // of the braces of a \text that is open; 0: none is
  uint32_t open_environments_ = 0;
  uint32_t looked_at_ = 0;  // perhaps farther than it was read
  bool is_done_ = false;
  FormulaEnd result_;
};

}  // namespace

FormulaEnd find_formula_end(std::string_view text, uint32_t begin, MathRegion region, const MathShortcut* shortcut) {
  return FormulaReader(text, begin, region, shortcut).run();
}

}  // namespace texbrdf

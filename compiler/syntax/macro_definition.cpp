#include "syntax/macro_definition.h"

#include <algorithm>
#include <array>

#include "source/characters.h"

namespace texbrdf {
namespace {

/// No definition that matters here is longer; one that is never closed costs no more than this.
constexpr uint32_t kLongestDefinition = 2048;
constexpr uint32_t kMostParameters = 9;

struct DefiningWord {
  std::string_view word;
  MacroForm form;
};
constexpr auto kDefiningWords = std::to_array<DefiningWord>({{"newcommand", MacroForm::Command},
                                                             {"renewcommand", MacroForm::Command},
                                                             {"DeclareRobustCommand", MacroForm::Command},
                                                             {"providecommand", MacroForm::Provided},
                                                             {"def", MacroForm::Plain},
                                                             {"gdef", MacroForm::Plain},
                                                             {"edef", MacroForm::Plain},
                                                             {"xdef", MacroForm::Plain},
                                                             {"let", MacroForm::Copy},
                                                             {"DeclareMathOperator", MacroForm::Operator},
                                                             {"DeclarePairedDelimiter", MacroForm::Brackets}});

/// Where the comments of a body stood, TeX sees nothing, not even the end of the line.
std::string without_comments(std::string_view body) {
  std::string result;
  for (size_t i = 0; i < body.size(); ++i) {
    if (body[i] == '\\' && i + 1 < body.size()) {
      result += body[i++];
    } else if (body[i] == '%') {
      while (i < body.size() && !is_line_end(body[i])) ++i;
      while (i + 1 < body.size() && is_space(body[i + 1])) ++i;
      continue;
    }
    result += body[i];
  }
  return result;
}

class DefinitionReader {
 public:
  DefinitionReader(std::string_view text, uint32_t begin, uint32_t behind_word)
      : text_(text.substr(0, std::min<size_t>(text.size(), size_t{begin} + kLongestDefinition))),
        begin_(begin),
        at_(behind_word) {}

  MacroReading run(MacroForm form) {
    found_.form = form;
    MacroReading reading;
    if (read(form)) {
      found_.span = {begin_, at_};
      reading.definition = std::move(found_);
    }
    reading.decided_at = std::min(static_cast<uint32_t>(text_.size()), std::max(at_, seen_) + 1);
    return reading;
  }

 private:
  bool read(MacroForm form) {
    switch (form) {
      case MacroForm::Command:
      case MacroForm::Provided:
        take('*');
        return read_name() && read_parameters() && read_body();
      case MacroForm::Plain:
        return read_name() && read_plain_parameters() && read_body();
      case MacroForm::Copy:
        return read_name() && read_original();
      case MacroForm::Operator:
        take('*');
        if (!read_name() || !read_body()) return false;
        found_.body = "\\operatorname{" + found_.body + "}";
        return true;
      case MacroForm::Brackets:
        return read_name() && read_brackets();
    }
    return false;
  }

  bool done() const { return at_ >= text_.size(); }
  bool at(char wanted) const { return !done() && text_[at_] == wanted; }
  bool take(char wanted) {
    skip_spaces();
    if (!at(wanted)) return false;
    ++at_;
    return true;
  }

  /// Comments are as good as spaces; a line without anything ends every definition.
  void skip_spaces() {
    while (!done() && (is_space(text_[at_]) || text_[at_] == '%')) {
      if (text_[at_] != '%') {
        ++at_;
        continue;
      }
      while (!done() && !is_line_end(text_[at_])) ++at_;
    }
  }

  /// `\x` or `{\x}`
  bool read_name() {
    const bool has_brace = take('{');
    skip_spaces();
    const uint32_t backslash = at_;
    const std::string_view word = read_word();
    if (word.empty() || word == "begin" || word == "end" || word == "verb") return false;
    found_.name = word;
    found_.name_span = {backslash, at_};
    return !has_brace || take('}');
  }

  /// Behind a backslash; empty, and nothing is consumed, where none stands.
  std::string_view read_word() {
    if (!at('\\')) return {};
    uint32_t end = at_ + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    // `\foo@bar` is no word of mathematics.
    if (end == at_ + 1 || (end < text_.size() && text_[end] == '@')) return {};
    const std::string_view word = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end;
    return word;
  }

  /// `[2][default]`
  bool read_parameters() {
    if (!take('[')) return true;
    skip_spaces();
    if (done() || text_[at_] < '0' || text_[at_] > '9') return false;
    found_.parameters = static_cast<uint32_t>(text_[at_++] - '0');
    if (!take(']')) return false;
    if (!take('[')) return true;
    const std::optional<std::string_view> fallback = up_to(']');
    if (!fallback || found_.parameters == 0) return false;
    found_.fallback = without_comments(*fallback);
    return true;
  }

  /// `#1#2`; parameters with anything between them are those of a programmer.
  bool read_plain_parameters() {
    while (!at('{')) {
      if (is_at_space()) {
        ++at_;
        continue;
      }
      const bool is_next =
          at('#') && at_ + 1 < text_.size() && text_[at_ + 1] == static_cast<char>('1' + found_.parameters);
      if (!is_next || found_.parameters == kMostParameters) return false;
      ++found_.parameters;
      at_ += 2;
    }
    return true;
  }
  bool is_at_space() const { return !done() && is_space(text_[at_]); }

  /// `{…}`, or one token.
  bool read_body() {
    std::optional<std::string_view> body = read_argument();
    if (!body) return false;
    found_.body = without_comments(*body);
    return true;
  }

  std::optional<std::string_view> read_argument() {
    if (take('{')) return up_to('}');
    const uint32_t begin = at_;
    const std::string_view word = read_word();
    return word.empty() ? std::nullopt : std::optional(text_.substr(begin, at_ - begin));
  }

  bool read_original() {
    take('=');
    skip_spaces();
    const uint32_t begin = at_;
    if (read_word().empty()) {
      if (done() || at('\\') || at('{') || at('}') || at('#')) return false;
      ++at_;
    }
    found_.body = text_.substr(begin, at_ - begin);
    return true;
  }

  bool read_brackets() {
    const std::optional<std::string_view> open = read_argument();
    const std::optional<std::string_view> close = open ? read_argument() : std::nullopt;
    if (!close) return false;
    found_.parameters = 1;
    found_.body = without_comments(*open) + " #1 " + without_comments(*close);
    return true;
  }

  /// What stands before the closer that belongs to no brace in between.
  std::optional<std::string_view> up_to(char closer) {
    const uint32_t begin = at_;
    uint32_t depth = 0;
    bool line_is_blank = false;
    for (uint32_t i = at_; i < text_.size(); ++i) {
      seen_ = std::max(seen_, i);
      const char c = text_[i];
      if (is_line_end(c)) {
        if (line_is_blank && c == '\n') return std::nullopt;
        if (c == '\n') line_is_blank = true;
        continue;
      }
      if (!is_space(c)) line_is_blank = false;
      if (c == closer && depth == 0) {
        at_ = i + 1;
        return text_.substr(begin, i - begin);
      }
      if (c == '\\') ++i;
      if (c == '{') ++depth;
      if (c == '}' && depth-- == 0) return std::nullopt;
      if (c == '%') {
        while (i + 1 < text_.size() && !is_line_end(text_[i + 1])) ++i;
      }
    }
    seen_ = static_cast<uint32_t>(text_.size());
    return std::nullopt;
  }

  std::string_view text_;
  uint32_t begin_;
  uint32_t at_;
  uint32_t seen_ = 0;
  MacroDefinition found_;
};

}  // namespace

bool defines_macros(std::string_view word) {
  return std::ranges::find(kDefiningWords, word, &DefiningWord::word) != kDefiningWords.end();
}

MacroReading read_macro_definition(std::string_view text, uint32_t begin, uint32_t behind_word) {
  const std::string_view word = text.substr(begin + 1, behind_word - begin - 1);
  const auto found = std::ranges::find(kDefiningWords, word, &DefiningWord::word);
  return DefinitionReader(text, begin, behind_word).run(found->form);
}

std::vector<MacroDefinition> find_macro_definitions(std::string_view text, Span stretch) {
  std::vector<MacroDefinition> found;
  const std::string_view seen = text.substr(0, stretch.end);
  for (size_t at = seen.find_first_of("\\%", stretch.begin); at < seen.size(); at = seen.find_first_of("\\%", at)) {
    if (seen[at] == '%') {
      at = std::min(seen.find_first_of("\r\n", at), seen.size());
      continue;
    }
    const size_t begin = at++;
    while (at < seen.size() && is_letter(seen[at])) ++at;
    if (at == begin + 1) {
      ++at;
      continue;
    }
    if (!defines_macros(seen.substr(begin + 1, at - begin - 1))) continue;
    MacroReading reading = read_macro_definition(seen, static_cast<uint32_t>(begin), static_cast<uint32_t>(at));
    if (!reading.definition) continue;
    at = reading.definition->span.end;
    found.push_back(std::move(*reading.definition));
  }
  return found;
}

}  // namespace texbrdf

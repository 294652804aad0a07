#include "syntax/lexer.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "source/utf8.h"
#include "syntax/control_words.h"
#include "syntax/math_regions.h"
#include "syntax/verbatim.h"

namespace texbrdf {
namespace {

enum class CharacterClass : uint8_t { Other, Space, Letter, Digit, Dot, Symbol, Backslash, Percent };

struct CharacterTable {
  std::array<CharacterClass, 256> classes{};
  std::array<TokenKind, 256> symbols{};

  constexpr CharacterTable() {
    set(" \t\n\r\f\v~", CharacterClass::Space);
    set("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", CharacterClass::Letter);
    set("0123456789", CharacterClass::Digit);
    set(".", CharacterClass::Dot);
    set("\\", CharacterClass::Backslash);
    set("%", CharacterClass::Percent);
    symbol('+', TokenKind::Plus);
    symbol('-', TokenKind::Minus);
    symbol('*', TokenKind::Multiply);
    symbol('/', TokenKind::Divide);
    symbol('^', TokenKind::Caret);
    symbol('_', TokenKind::Underscore);
    symbol('\'', TokenKind::Prime);
    symbol('=', TokenKind::Equals);
    symbol('|', TokenKind::Bar);
    symbol(',', TokenKind::Comma);
    symbol(';', TokenKind::Comma);
    symbol('<', TokenKind::Relation);
    symbol('>', TokenKind::Relation);
    symbol('(', TokenKind::OpenParen);
    symbol(')', TokenKind::CloseParen);
    symbol('{', TokenKind::OpenBrace);
    symbol('}', TokenKind::CloseBrace);
    symbol('[', TokenKind::OpenBracket);
    symbol(']', TokenKind::CloseBracket);
    symbol('&', TokenKind::Ampersand);
  }

  constexpr void set(std::string_view characters, CharacterClass value) {
    for (const char c : characters) classes[static_cast<unsigned char>(c)] = value;
  }
  constexpr void symbol(char c, TokenKind kind) {
    classes[static_cast<unsigned char>(c)] = CharacterClass::Symbol;
    symbols[static_cast<unsigned char>(c)] = kind;
  }
};

constexpr CharacterTable kCharacters;

CharacterClass class_of(char c) {
  return kCharacters.classes[static_cast<unsigned char>(c)];
}

bool is_spacing_symbol(char c) {
  return c == ',' || c == ';' || c == ':' || c == '!' || c == '/' || class_of(c) == CharacterClass::Space;
}

/// Tokens on the stack while they are few, as nearly always.
class TokenBuffer {
 public:
  explicit TokenBuffer(size_t capacity) {
    if (capacity > near_.size()) {
      far_ = std::make_unique_for_overwrite<Token[]>(capacity);
      next_ = first_ = far_.get();
    }
  }
  void push(TokenKind kind, Command command, uint32_t begin, uint32_t end) {
    next_->kind = kind;
    next_->command = command;
    next_->origin = 0;
    next_->span = {begin, end};
    ++next_;
  }
  std::pmr::vector<Token> tokens(std::pmr::memory_resource* memory) const { return {first_, next_, memory}; }

 private:
  struct Slots {
    Token* data() { return reinterpret_cast<Token*>(bytes); }
    static constexpr size_t size() { return 1024; }
    alignas(Token) unsigned char bytes[1024 * sizeof(Token)];
  };
  Slots near_;
  std::unique_ptr<Token[]> far_;
  Token* first_ = near_.data();
  Token* next_ = first_;
};

class Lexer {
 public:
  Lexer(std::string_view text, Span content, bool has_columns, std::pmr::memory_resource* memory)
      : text_(text.substr(0, content.end)),
        at_(content.begin),
        columns_(has_columns ? 1 : 0),
        memory_(memory),
        buffer_(content.size() + size_t{1}),
        comments_(memory) {}

  LexedContent run(Span end) {
    while (!done()) lex_one();
    push(TokenKind::End, end.begin, end.end);
    return {buffer_.tokens(memory_), std::move(comments_)};
  }

 private:
  bool done() const { return at_ >= text_.size(); }
  char current() const { return text_[at_]; }
  bool at(CharacterClass wanted) const { return !done() && class_of(current()) == wanted; }
  bool at(char wanted) const { return !done() && current() == wanted; }
  void skip(CharacterClass wanted) {
    while (at(wanted)) ++at_;
  }
  void push(TokenKind kind, uint32_t begin, uint32_t end, Command command = Command::None) {
    buffer_.push(kind, command, begin, end);
  }

  void lex_one() {
    const uint32_t begin = at_;
    switch (class_of(current())) {
      case CharacterClass::Space:
        ++at_;
        return;
      case CharacterClass::Letter:
        skip(CharacterClass::Letter);
        return push(TokenKind::Word, begin, at_);
      case CharacterClass::Digit:
        return lex_number();
      case CharacterClass::Dot:
        return digit_follows(at_ + 1) ? lex_number() : lex_unknown();
      case CharacterClass::Symbol:
        if (current() == '{' && lex_text_declaration()) return;
        ++at_;
        if (closes_a_box(text_[begin])) return;
        return push(symbol_kind(text_[begin]), begin, at_);
      case CharacterClass::Backslash:
        return lex_command();
      case CharacterClass::Percent:
        skip_comment();
        comments_.push_back({begin, at_});
        return;
      case CharacterClass::Other:
        return lex_unknown();
    }
  }

  /// Counts braces; those of `\boxed{…}` are no tokens.
  bool closes_a_box(char symbol) {
    if (symbol == '{') ++open_braces_;
    if (symbol != '}' || open_braces_ == 0) return false;
    const bool is_box = !boxes_.empty() && boxes_.back() == open_braces_;
    if (is_box) boxes_.pop_back();
    --open_braces_;
    return is_box;
  }

  void open_box() {
    const uint32_t open = behind_spaces(at_);
    if (open >= text_.size() || text_[open] != '{' || !holds_relation(open)) return;
    at_ = open + 1;
    boxes_.push_back(++open_braces_);
  }

  /// The group at `open` is a whole equation. Once one has no end the block is broken, and no other is asked.
  bool holds_relation(uint32_t open) {
    uint32_t depth = 0;
    bool found = false;
    for (uint32_t i = open; i < text_.size() && !an_open_box_was_met_; ++i) {
      if (text_[i] == '\\')
        ++i;
      else if (text_[i] == '{')
        ++depth;
      else if (text_[i] == '}' && --depth == 0)
        return found;
      else if (text_[i] == '=' && depth == 1)
        found = true;
    }
    an_open_box_was_met_ = true;
    return false;
  }

  TokenKind symbol_kind(char symbol) const {
    const TokenKind kind = kCharacters.symbols[static_cast<unsigned char>(symbol)];
    return kind == TokenKind::Ampersand && columns_ > 0 ? TokenKind::Gap : kind;
  }

  bool digit_follows(uint32_t at) const { return at < text_.size() && class_of(text_[at]) == CharacterClass::Digit; }

  /// digits [. digits] [e [sign] digits], or . digits [e …]
  void lex_number() {
    const uint32_t begin = at_;
    skip(CharacterClass::Digit);
    if (at('.') && digit_follows(at_ + 1)) {
      ++at_;
      skip(CharacterClass::Digit);
    }
    if (at('e') || at('E')) {
      const bool has_sign = at_ + 1 < text_.size() && (text_[at_ + 1] == '+' || text_[at_ + 1] == '-');
      const uint32_t digits = at_ + (has_sign ? 2 : 1);
      if (digit_follows(digits)) {
        at_ = digits;
        skip(CharacterClass::Digit);
      }
    }
    push(TokenKind::Number, begin, at_);
  }

  void lex_unknown() {
    const uint32_t begin = at_;
    if (text_.substr(at_).starts_with(":=")) {
      at_ += 2;
      return push(TokenKind::Equals, begin, at_);
    }
    at_ += code_point_at_front(text_.substr(at_)).size;
    push(TokenKind::Unknown, begin, at_);
  }

  void skip_comment() {
    while (!done() && current() != '\n' && current() != '\r') ++at_;
  }

  void lex_command() {
    const uint32_t begin = at_++;
    if (!at(CharacterClass::Letter)) return lex_control_symbol(begin);
    skip(CharacterClass::Letter);
    const ControlWord& word = find_control_word(text_.substr(begin + 1, at_ - begin - 1));
    switch (word.meaning) {
      case WordMeaning::Name:
      case WordMeaning::Command:
      case WordMeaning::Token:
        push(word.kind, begin, at_, word.command);
        if (word.kind == TokenKind::Frac) lex_digit_arguments();
        return;
      case WordMeaning::Vec:
      case WordMeaning::Accent:
        push(word.kind, begin, at_, word.command);
        return lex_decorated_letter();
      case WordMeaning::Nothing:
      case WordMeaning::TextDeclaration:
        return;
      case WordMeaning::NothingWithGroup:
        return skip_meaningless_group();
      case WordMeaning::NothingWithBraces:
        return open_box();
      case WordMeaning::Delimiter:
        return lex_delimiter();
      case WordMeaning::Text:
        return lex_text(begin);
      case WordMeaning::Environment:
        return lex_environment(begin);
      case WordMeaning::EnvironmentEnd:
        return lex_environment_end(begin);
      case WordMeaning::Verbatim:
        at_ = static_cast<uint32_t>(end_of_verb(text_, at_));
        return push(TokenKind::Unknown, begin, at_);
    }
  }

  /// A backslash and what is no letter.
  void lex_control_symbol(uint32_t begin) {
    if (done()) return push(TokenKind::Unknown, begin, at_);
    const char symbol = current();
    at_ += code_point_at_front(text_.substr(at_)).size;
    if (is_spacing_symbol(symbol)) return;
    if (symbol == '\\') {
      if (at('*')) ++at_;
      if (at('[')) skip_line_distance();
      return push(TokenKind::NewRow, begin, at_);
    }
    if (symbol == '{') return push(TokenKind::OpenSet, begin, at_);
    if (symbol == '}') return push(TokenKind::CloseSet, begin, at_);
    if (symbol == '|') return push(TokenKind::DoubleBar, begin, at_);
    push(TokenKind::Unknown, begin, at_);
  }

  /// What is no delimiter by itself: `\left.` and `\left<`.
  void lex_delimiter() {
    const uint32_t begin = behind_spaces(at_);
    const char delimiter = begin < text_.size() ? text_[begin] : ' ';
    if (delimiter != '.' && delimiter != '<' && delimiter != '>') return;
    at_ = begin + 1;
    if (delimiter == '<') push(TokenKind::OpenAngle, begin, at_);
    if (delimiter == '>') push(TokenKind::CloseAngle, begin, at_);
  }

  /// `\\[2pt]`
  void skip_line_distance() {
    uint32_t close = at_;
    while (close < text_.size() && text_[close] != ']' && text_[close] != '\n' && text_[close] != '\\') ++close;
    if (close < text_.size() && text_[close] == ']') at_ = close + 1;
  }

  /// `\label{…}`, `\tag*{…}`; without a group that is closed only the word means nothing.
  void skip_meaningless_group() {
    const uint32_t behind_word = at_;
    if (at('*')) ++at_;
    const std::optional<uint32_t> end = end_of_group();
    at_ = end.value_or(behind_word);
  }

  /// `\text{…}`, or `\mathrm d`, which takes one letter.
  void lex_text(uint32_t begin) {
    if (at('*')) ++at_;
    const uint32_t behind_word = at_;
    std::optional<uint32_t> end = end_of_group();
    const uint32_t argument = behind_spaces(at_);
    if (!end && is_letter_at(argument)) end = argument + 1;
    at_ = end.value_or(behind_word);
    push(end ? TokenKind::Text : TokenKind::Unknown, begin, at_);
  }

  /// `{\rm …}` around nothing but characters; at_ is the brace.
  bool lex_text_declaration() {
    const uint32_t command = behind_spaces(at_ + 1);
    if (command >= text_.size() || text_[command] != '\\') return false;
    uint32_t end = command + 1;
    while (is_letter_at(end)) ++end;
    if (find_control_word(text_.substr(command + 1, end - command - 1)).meaning != WordMeaning::TextDeclaration) {
      return false;
    }
    const size_t close = text_.find_first_of("{}\\%", end);
    if (close == std::string_view::npos || text_[close] != '}' || behind_spaces(end) == close) return false;
    push(TokenKind::Text, at_, static_cast<uint32_t>(close) + 1);
    at_ = static_cast<uint32_t>(close) + 1;
    return true;
  }

  /// `\mathbf nl` is a bold n, and l behind it.
  void lex_decorated_letter() {
    const uint32_t letter = behind_spaces(at_);
    if (!is_letter_at(letter)) return;
    push(TokenKind::Word, letter, letter + 1);
    at_ = letter + 1;
  }

  /// `\frac12` is a half.
  void lex_digit_arguments() {
    for (int argument = 0; argument < 2; ++argument) {
      const uint32_t digit = behind_spaces(at_);
      if (!digit_follows(digit)) return;
      push(TokenKind::Number, digit, digit + 1);
      at_ = digit + 1;
    }
  }

  bool is_letter_at(uint32_t at) const { return at < text_.size() && class_of(text_[at]) == CharacterClass::Letter; }
  uint32_t behind_spaces(uint32_t at) const {
    while (at < text_.size() && class_of(text_[at]) == CharacterClass::Space) ++at;
    return at;
  }

  /// The end of the brace group that follows after spaces, if one follows and is closed. One that holds `\begin` or
  /// `\verb` is none: what ends blocks is not seen in there, and braces do not count.
  std::optional<uint32_t> end_of_group() {
    uint32_t i = at_;
    while (i < text_.size() && class_of(text_[i]) == CharacterClass::Space) ++i;
    if (i >= text_.size() || text_[i] != '{' || an_open_group_was_met_) return std::nullopt;
    for (uint32_t depth = 0; i < text_.size(); ++i) {
      switch (text_[i]) {
        case '\\':
          if (is_verbatim_at(i + 1)) {
            an_open_group_was_met_ = true;
            return std::nullopt;
          }
          ++i;
          break;
        case '%':
          while (i + 1 < text_.size() && text_[i + 1] != '\n' && text_[i + 1] != '\r') ++i;
          break;
        case '{':
          ++depth;
          break;
        case '}':
          if (--depth == 0) return i + 1;
          break;
        default:
          break;
      }
    }
    an_open_group_was_met_ = true;
    return std::nullopt;
  }

  bool is_verbatim_at(uint32_t behind_backslash) const {
    uint32_t end = behind_backslash;
    while (end < text_.size() && class_of(text_[end]) == CharacterClass::Letter) ++end;
    const WordMeaning meaning = find_control_word(text_.substr(behind_backslash, end - behind_backslash)).meaning;
    return meaning == WordMeaning::Environment || meaning == WordMeaning::Verbatim;
  }

  /// One that the language does not know is one token with all that it holds; a comment environment is none.
  void lex_environment(uint32_t begin) {
    const std::optional<uint32_t> name_end = end_of_group();
    if (!name_end) return push(TokenKind::Unknown, begin, at_);
    const std::string_view group = group_up_to(*name_end);
    if (const MathEnvironment* environment = find_math_environment(name_in(group))) {
      at_ = *name_end;
      if (environment->has_columns) ++columns_;
      return skip_environment_argument(*environment);
    }
    const uint32_t unclosed_end = is_raw_environment(name_in(group)) ? static_cast<uint32_t>(text_.size()) : *name_end;
    at_ = end_of_environment(group, *name_end).value_or(unclosed_end);
    if (group != "{comment}") push(TokenKind::Unknown, begin, at_);
  }

  void lex_environment_end(uint32_t begin) {
    const std::optional<uint32_t> name_end = end_of_group();
    const MathEnvironment* environment = name_end ? find_math_environment(name_in(group_up_to(*name_end))) : nullptr;
    if (environment == nullptr) return push(TokenKind::Macro, begin, at_);
    at_ = *name_end;
    if (environment->has_columns && columns_ > 0) --columns_;
  }

  std::string_view group_up_to(uint32_t end) const {
    const size_t open = text_.find('{', at_);
    return text_.substr(open, end - open);
  }
  static std::string_view name_in(std::string_view group) { return group.substr(1, group.size() - 2); }

  /// `{2}` of alignedat, `[t]` of aligned.
  void skip_environment_argument(const MathEnvironment& environment) {
    if (at('[')) skip_line_distance();
    if (environment.has_argument) at_ = end_of_group().value_or(at_);
  }

  std::optional<uint32_t> end_of_environment(std::string_view group, uint32_t from) {
    if (an_open_environment_was_met_) return std::nullopt;
    uint32_t depth = 1;
    for (size_t i = text_.find(group, from); i != std::string_view::npos; i = text_.find(group, i + 1)) {
      const std::string_view before = text_.substr(0, i);
      if (before.ends_with("\\begin")) ++depth;
      if (before.ends_with("\\end") && --depth == 0) return static_cast<uint32_t>(i + group.size());
    }
    an_open_environment_was_met_ = true;
    return std::nullopt;
  }

  std::string_view text_;
  uint32_t at_;
  uint32_t columns_;  // open environments in which `&` separates columns
  std::pmr::memory_resource* memory_;
  TokenBuffer buffer_;
  uint32_t open_braces_ = 0;
  std::vector<uint32_t> boxes_;  // how many braces were open with the one of a box
  std::pmr::vector<Span> comments_;
  // Once one search has met the end in vain the block is broken; searching again and again would not be linear.
  bool an_open_group_was_met_ = false;
  bool an_open_environment_was_met_ = false;
  bool an_open_box_was_met_ = false;
};

}  // namespace

LexedContent lex(std::string_view text, Span content, bool has_columns, Span end, std::pmr::memory_resource* memory) {
  return Lexer(text, content, has_columns, memory).run(end);
}

}  // namespace texbrdf

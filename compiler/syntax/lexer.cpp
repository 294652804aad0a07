#include "syntax/lexer.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "source/characters.h"
#include "source/trimmed.h"
#include "source/utf8.h"
#include "syntax/control_words.h"
#include "syntax/differentials.h"
#include "syntax/math_regions.h"
#include "syntax/open_environments.h"
#include "syntax/remark.h"
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

/// Of notes that are typed, not written in LaTeX.
struct UnicodeSymbol {
  std::string_view character;
  TokenKind kind;
};
constexpr auto kUnicode = std::to_array<UnicodeSymbol>({{"·", TokenKind::Multiply},
                                                        {"⋅", TokenKind::Multiply},
                                                        {"×", TokenKind::Cross},
                                                        {"−", TokenKind::Minus},
                                                        {"≈", TokenKind::Equals},
                                                        {"≤", TokenKind::Relation},
                                                        {"≥", TokenKind::Relation},
                                                        {"≠", TokenKind::Relation}});

constexpr size_t kShortestFunction = 2;
constexpr size_t kLongestFunction = 6;

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
    next_->span = {begin, end};
    ++next_;
  }
  bool ends_with(TokenKind kind) const { return next_ != first_ && next_[-1].kind == kind; }
  bool empty() const { return next_ == first_; }
  const Token& last() const { return next_[-1]; }
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
    buffer_.push(TokenKind::End, Command::None, end.begin, end.end);
    LexedContent content{buffer_.tokens(memory_), std::move(comments_)};
    mark_differentials(text_, content.tokens);
    return content;
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
    if (environments_.in_rows()) kind = kind_in_rows(kind, begin, end);
    buffer_.push(kind, command, begin, end);
  }
  TokenKind kind_in_rows(TokenKind kind, uint32_t begin, uint32_t end) {
    const Span before = last_token().span;
    return environments_.kind_in_rows(kind, text_.substr(begin, end - begin), last_token().kind,
                                      text_.substr(before.begin, before.size()));
  }
  Token last_token() const {
    return buffer_.empty() ? Token{.kind = TokenKind::End, .span = {at_, at_}} : buffer_.last();
  }

  void lex_one() {
    const uint32_t begin = at_;
    switch (class_of(current())) {
      case CharacterClass::Space:
        ++at_;
        return;
      case CharacterClass::Letter:
        skip_word();
        return lex_word(begin);
      case CharacterClass::Digit:
        return lex_number();
      case CharacterClass::Dot:
        if (digit_follows(at_ + 1)) return lex_number();
        if (is_dot_between_names()) return push(TokenKind::Multiply, begin, ++at_);
        return lex_unknown();
      case CharacterClass::Symbol:
        if (current() == '{' && lex_text_declaration()) return;
        ++at_;
        return lex_symbol(begin);
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

  /// `cook\_torrance` is one.
  void skip_word() {
    skip(CharacterClass::Letter);
    while (text_.substr(at_).starts_with("\\_") && is_letter_at(at_ + 2)) {
      at_ += 2;
      skip(CharacterClass::Letter);
    }
  }

  /// `cos(x)`: a function whose backslash was forgotten.
  void lex_word(uint32_t begin) {
    const ControlWord& word = bare_function(text_.substr(begin, at_ - begin));
    push(word.command == Command::None ? TokenKind::Word : word.kind, begin, at_, word.command);
  }

  /// The function that the letters before at_ name where an operand stands behind them.
  const ControlWord& bare_function(std::string_view letters) const {
    static constexpr ControlWord kNone;
    if (letters.size() < kShortestFunction || letters.size() > kLongestFunction) return kNone;
    const ControlWord& word = find_control_word(letters);
    if (word.kind != TokenKind::Function && word.kind != TokenKind::Extremum) return kNone;
    return reserves_word(word.command) && operand_follows(word.kind) ? word : kNone;
  }

  bool operand_follows(TokenKind function) const {
    const uint32_t next = behind_spacing(at_);
    if (next >= text_.size()) return false;
    const char c = text_[next];
    if (c == '(' || c == '[') return true;
    const bool is_extremum = function == TokenKind::Extremum;
    if (c != '\\') return !is_extremum && (c == '{' || c == '^' || is_letter_at(next) || digit_follows(next));
    if (next + 1 < text_.size() && text_[next + 1] == '{') return true;
    const ControlWord& word = find_control_word(letters_at(next + 1));
    switch (word.meaning) {
      case WordMeaning::Delimiter:
        return word.spelling != "right" && word.spelling != "middle" && !word.spelling.ends_with('r');
      case WordMeaning::Command:
        return !is_extremum && (word.kind == TokenKind::Function || word.kind == TokenKind::Frac ||
                                word.kind == TokenKind::Sqrt || word.kind == TokenKind::Extremum);
      case WordMeaning::Name:
      case WordMeaning::Vec:
      case WordMeaning::Accent:
      case WordMeaning::Text:
        return !is_extremum && is_letter_at(next + 1);
      case WordMeaning::Token:
        return word.kind == TokenKind::OpenBracket || word.kind == TokenKind::OpenSet;
      case WordMeaning::Nothing:
      case WordMeaning::NothingWithGroup:
      case WordMeaning::NothingWithBraces:
      case WordMeaning::NothingWithScript:
      case WordMeaning::TextDeclaration:
      case WordMeaning::Environment:
      case WordMeaning::EnvironmentEnd:
      case WordMeaning::Verbatim:
        return false;
    }
    return false;
  }

  std::string_view letters_at(uint32_t begin) const {
    uint32_t end = begin;
    while (is_letter_at(end)) ++end;
    return text_.substr(begin, end - begin);
  }

  /// Spaces, and the commands that stand for them.
  uint32_t behind_spacing(uint32_t at) const {
    for (;;) {
      at = behind_spaces(at);
      const bool is_spacing = at + 1 < text_.size() && text_[at] == '\\' && is_spacing_symbol(text_[at + 1]);
      if (!is_spacing) return at;
      at += 2;
    }
  }

  void lex_symbol(uint32_t begin) {
    const char symbol = text_[begin];
    if (symbol == '{') ++open_braces_;
    const bool closes = symbol == '}' && open_braces_ > 0;
    const bool closes_box = closes && takes_innermost(boxes_);
    const bool closes_labelled = closes && takes_innermost(labelled_);
    const bool closes_numerator = closes && takes_innermost(numerators_);
    if (closes) --open_braces_;
    if (!closes_box) push(symbol_kind(symbol), begin, at_);
    if (closes_labelled) skip_label();
    if (closes_numerator) lex_digit();
  }

  /// Of groups, by how many braces are open in them; the innermost is no more.
  bool takes_innermost(std::vector<uint32_t>& groups) const {
    if (groups.empty() || groups.back() != open_braces_) return false;
    groups.pop_back();
    return true;
  }

  /// `\underbrace{…}_{\text{sheen}}`
  void skip_label() {
    const uint32_t script = behind_spaces(at_);
    if (script >= text_.size() || (text_[script] != '_' && text_[script] != '^')) return;
    const uint32_t behind_group = std::exchange(at_, script + 1);
    at_ = end_of_group().value_or(behind_group);
  }

  /// `\mathop{max}`, `\mathop{\rm max}`, where the group holds nothing but a word.
  bool lex_named_operator(uint32_t begin) {
    const std::optional<uint32_t> end = end_of_group();
    if (!end) return false;
    std::string_view content = trimmed(group_up_to(*end), " \t\r\n{}");
    if (content.starts_with('\\')) {
      const size_t behind_font = content.find_first_of(" {", 1);
      if (behind_font == std::string_view::npos) return false;
      content = trimmed(content.substr(behind_font), " \t\r\n{}");
    }
    if (content.empty() || !std::ranges::all_of(content, is_letter)) return false;
    const uint32_t behind_word = std::exchange(at_, *end);
    const ControlWord& function = bare_function(content);
    if (function.command != Command::None) {
      push(function.kind, begin, at_, function.command);
      return true;
    }
    at_ = behind_word;
    return false;
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

  /// `N.L`, `\mathbf{v}.\mathbf{x}`
  bool is_dot_between_names() const {
    if (at_ == 0 || !is_letter_or_brace(text_[at_ - 1])) return false;
    if (is_letter_at(at_ + 1)) return true;
    if (at_ + 1 >= text_.size() || text_[at_ + 1] != '\\' || !is_letter_at(at_ + 2)) return false;
    const WordMeaning meaning = find_control_word(letters_at(at_ + 2)).meaning;
    return meaning == WordMeaning::Name || meaning == WordMeaning::Vec;
  }
  static bool is_letter_or_brace(char c) { return class_of(c) == CharacterClass::Letter || c == '}'; }

  void lex_unknown() {
    const uint32_t begin = at_;
    if (text_.substr(at_).starts_with(":=")) {
      at_ += 2;
      return push(TokenKind::Equals, begin, at_);
    }
    at_ += code_point_at_front(text_.substr(at_)).size;
    const auto character = std::ranges::find(kUnicode, text_.substr(begin, at_ - begin), &UnicodeSymbol::character);
    if (character != kUnicode.end()) return push(character->kind, begin, at_);
    const bool is_text_mode_column = text_[begin] == '$' && environments_.in_cases();
    if (!is_text_mode_column) push(TokenKind::Unknown, begin, at_);
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
        if (begins_difference(begin)) return push(TokenKind::Accent, begin, at_);
        if (word.kind == TokenKind::OpenSet && rows_follow()) return;
        push(word.kind, begin, at_, word.command);
        if (word.kind == TokenKind::Frac) lex_short_arguments();
        if (word.kind == TokenKind::Sqrt) lex_digit();
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
        if (word.spelling != "mathop" || !lex_named_operator(begin)) open_box();
        return;
      case WordMeaning::NothingWithScript:
        if (behind_spaces(at_) < text_.size() && text_[behind_spaces(at_)] == '{')
          labelled_.push_back(open_braces_ + 1);
        return;
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

  /// `\Delta\phi`, which papers define as a name.
  bool begins_difference(uint32_t begin) const {
    if (text_.substr(begin, at_ - begin) != "\\Delta" || buffer_.ends_with(TokenKind::Underscore)) return false;
    const uint32_t next = behind_spaces(at_);
    if (is_letter_at(next)) return true;
    if (next >= text_.size() || text_[next] != '\\') return false;
    const WordMeaning meaning = find_control_word(letters_at(next + 1)).meaning;
    return is_letter_at(next + 1) && (meaning == WordMeaning::Name || meaning == WordMeaning::Vec);
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
    if (symbol == '{' && rows_follow()) return;
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
    if (!end) return push(TokenKind::Unknown, begin, at_);
    if (environments_.in_cases() && lex_remark(begin)) return;
    push_text(begin, text_.substr(argument, at_ - argument));
  }

  /// `\operatorname{sin}\theta` is `\sin\theta`; in a subscript it is a text as any other.
  void push_text(uint32_t begin, std::string_view content) {
    const bool is_subscript = buffer_.ends_with(TokenKind::Underscore);
    const ControlWord& word = bare_function(is_subscript ? "" : trimmed(content, " \t\r\n{}"));
    push(word.command == Command::None ? TokenKind::Text : word.kind, begin, at_, word.command);
  }

  /// `\text{otherwise}`, or `\text{if $x > 0$}`, which is remarks with mathematics in between; it ends at at_.
  bool lex_remark(uint32_t begin) {
    const uint32_t end = at_;
    const TokenKind before = last_token().kind;
    if (before == TokenKind::Underscore || before == TokenKind::Caret) return false;
    const std::string_view whole = std::exchange(text_, text_.substr(0, end));
    const bool holds_formula = text_.find('$', begin) != std::string_view::npos;
    const RemarkKind kind = read_remark(text_.substr(begin));
    const bool is_name =
        kind == RemarkKind::Unknown || (kind == RemarkKind::Nothing && !holds_words(text_.substr(begin)));
    const bool is_remark = holds_formula || !is_name;
    if (is_remark) lex_remark_parts(begin);
    text_ = whole;
    at_ = end;
    return is_remark;
  }

  void lex_remark_parts(uint32_t begin) {
    const auto end = static_cast<uint32_t>(text_.size());
    for (uint32_t from = begin; from < end;) {
      const auto words_end = static_cast<uint32_t>(std::min<size_t>(text_.find('$', from), end));
      if (words_end > from) push(TokenKind::Remark, from, words_end);
      if (words_end == end) return;
      const auto formula_end = static_cast<uint32_t>(std::min<size_t>(text_.find('$', words_end + 1), end - 1));
      at_ = words_end + 1;
      const std::string_view remark = std::exchange(text_, text_.substr(0, formula_end));
      while (!done()) lex_one();
      text_ = remark;
      from = text_[formula_end] == '$' ? formula_end + 1 : formula_end;
    }
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
    const uint32_t begin = std::exchange(at_, static_cast<uint32_t>(close) + 1);
    if (!environments_.in_cases() || !lex_remark(begin)) push_text(begin, text_.substr(end, close - end));
    return true;
  }

  /// `\mathbf nl` is a bold n, and l behind it.
  void lex_decorated_letter() {
    const uint32_t letter = behind_spaces(at_);
    if (!is_letter_at(letter)) return;
    push(TokenKind::Word, letter, letter + 1);
    at_ = letter + 1;
  }

  /// `\frac12` is a half, and `\frac hb` is h/b. Longer words are no two arguments that anybody would write so.
  void lex_short_arguments() {
    for (int argument = 0; argument < 2; ++argument) {
      const uint32_t symbol = behind_spaces(at_);
      const bool is_letter = is_letter_at(symbol) && (argument == 1 || !is_letter_at(symbol + 2));
      if (!is_letter && !digit_follows(symbol)) return note_numerator(symbol);
      push(is_letter ? TokenKind::Word : TokenKind::Number, symbol, symbol + 1);
      at_ = symbol + 1;
    }
  }

  void note_numerator(uint32_t opener) {
    if (opener < text_.size() && text_[opener] == '{') numerators_.push_back(open_braces_ + 1);
  }

  /// `\sqrt 2`, `\frac{1}2`: an argument is one digit.
  void lex_digit() {
    const uint32_t digit = behind_spaces(at_);
    if (!digit_follows(digit)) return;
    push(TokenKind::Number, digit, digit + 1);
    at_ = digit + 1;
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
      return open_environment(*environment, begin);
    }
    const uint32_t unclosed_end = is_raw_environment(name_in(group)) ? static_cast<uint32_t>(text_.size()) : *name_end;
    at_ = end_of_environment(group, *name_end).value_or(unclosed_end);
    if (group != "{comment}") push(TokenKind::Unknown, begin, at_);
  }

  void open_environment(const MathEnvironment& environment, uint32_t begin) {
    const uint32_t end = at_;
    const bool is_behind_brace = std::exchange(is_behind_brace_, false);
    if (environment.is_operand() || is_behind_brace) {
      const bool is_cases = is_behind_brace || environment.role == MathEnvironment::Role::Cases;
      push(is_cases ? TokenKind::OpenCases : TokenKind::OpenMatrix, begin, end);
    } else if (environment.has_columns) {
      ++columns_;
    }
    environments_.open(environment, is_behind_brace);
    skip_environment_argument(environment);
  }

  void lex_environment_end(uint32_t begin) {
    const std::optional<uint32_t> name_end = end_of_group();
    const MathEnvironment* environment = name_end ? find_math_environment(name_in(group_up_to(*name_end))) : nullptr;
    const std::optional<OpenEnvironments::Entry> closed =
        name_end ? environments_.close(environment) : std::optional<OpenEnvironments::Entry>();
    if (environment == nullptr && !closed) return push(TokenKind::Macro, begin, at_);
    at_ = *name_end;
    if (closed && closed->is_operand()) return close_rows(*closed, begin);
    if (environment->is_operand()) return push(closer_of_stray(*environment), begin, at_);
    if (environment->has_columns && columns_ > 0) --columns_;
  }

  static TokenKind closer_of_stray(const MathEnvironment& environment) {
    return environment.role == MathEnvironment::Role::Cases ? TokenKind::CloseCases : TokenKind::CloseMatrix;
  }

  void close_rows(const OpenEnvironments::Entry& rows, uint32_t begin) {
    push(rows.closer(), begin, at_);
    if (!rows.is_behind_brace) return;
    const uint32_t behind = behind_spaces(at_);
    for (const std::string_view brace : {"\\right\\}", "\\right\\rbrace", "\\}"}) {
      if (text_.substr(behind).starts_with(brace)) at_ = behind + static_cast<uint32_t>(brace.size());
    }
  }

  /// `\{` before an array is no bracket: the rows are cases.
  bool rows_follow() {
    constexpr std::string_view kBegin = "\\begin{";
    const std::string_view rest = text_.substr(behind_spaces(at_));
    if (!rest.starts_with(kBegin)) return false;
    constexpr size_t kLongestName = 16;
    const std::string_view name = rest.substr(kBegin.size(), kLongestName);
    const MathEnvironment* const environment = find_math_environment(name.substr(0, name.find('}')));
    const bool is_open = environment != nullptr && environment->role != MathEnvironment::Role::Display &&
                         environment->role != MathEnvironment::Role::Cases;
    is_behind_brace_ = is_behind_brace_ || is_open;
    return is_open;
  }

  std::string_view group_up_to(uint32_t end) const {
    const size_t open = text_.find('{', at_);
    return text_.substr(open, end - open);
  }
  static std::string_view name_in(std::string_view group) { return group.substr(1, group.size() - 2); }

  /// `{2}` of alignedat, `[t]` of aligned.
  void skip_environment_argument(const MathEnvironment& environment) {
    if (at('[') && environment.role != MathEnvironment::Role::Cases) skip_line_distance();
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
  OpenEnvironments environments_;
  bool is_behind_brace_ = false;  // the next \begin is
  std::pmr::memory_resource* memory_;
  TokenBuffer buffer_;
  uint32_t open_braces_ = 0;
  // How many braces were open with the one of a box, of a group with a label, or of a numerator.
  std::vector<uint32_t> boxes_;
  std::vector<uint32_t> labelled_;
  std::vector<uint32_t> numerators_;
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

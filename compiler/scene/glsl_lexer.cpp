#include "scene/glsl_lexer.h"

#include <algorithm>

namespace texbrdf::scene {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

class Lexer {
 public:
  explicit Lexer(std::string_view code) : code_(code) {}

  std::vector<GlslToken> run() {
    while (at_ < code_.size()) {
      const std::size_t begin = at_;
      const uint32_t line = line_;
      if (code_[at_] == '#' && at_line_begin_) in_directive_ = true;
      const bool in_directive = in_directive_;
      const GlslTokenKind kind = step();
      const std::string_view text = code_.substr(begin, at_ - begin);
      tokens_.push_back({kind, text, line, in_directive});
      if (kind != GlslTokenKind::Blank) at_line_begin_ = false;
    }
    return std::move(tokens_);
  }

 private:
  char next(std::size_t ahead = 0) const { return at_ + ahead < code_.size() ? code_[at_ + ahead] : '\0'; }

  GlslTokenKind step() {
    const char c = next();
    if (is_blank(c) || continues_line()) return blank();
    if (c == '/' && next(1) == '/') return line_comment();
    if (c == '/' && next(1) == '*') return block_comment();
    if (is_letter(c)) {
      while (is_letter(next()) || is_digit(next())) ++at_;
      return GlslTokenKind::Word;
    }
    if (is_digit(c) || (c == '.' && is_digit(next(1)))) return number();
    ++at_;
    return GlslTokenKind::Sign;
  }

  bool continues_line() const { return next() == '\\' && (next(1) == '\n' || (next(1) == '\r' && next(2) == '\n')); }

  GlslTokenKind blank() {
    while (continues_line()) {
      at_ += next(1) == '\n' ? 2 : 3;
      ++line_;
      return GlslTokenKind::Blank;
    }
    while (at_ < code_.size() && is_blank(next())) {
      if (next() == '\n') end_line();
      ++at_;
      if (!in_directive_) continue;
      return GlslTokenKind::Blank;
    }
    return GlslTokenKind::Blank;
  }

  void end_line() {
    ++line_;
    at_line_begin_ = true;
    in_directive_ = false;
  }

  GlslTokenKind line_comment() {
    at_ = std::min(code_.find('\n', at_), code_.size());
    return GlslTokenKind::Blank;
  }

  GlslTokenKind block_comment() {
    const std::size_t end = code_.find("*/", at_ + 2);
    const std::size_t stop = end == std::string_view::npos ? code_.size() : end + 2;
    line_ += static_cast<uint32_t>(std::count(code_.begin() + static_cast<std::ptrdiff_t>(at_),
                                              code_.begin() + static_cast<std::ptrdiff_t>(stop), '\n'));
    at_ = stop;
    return end == std::string_view::npos ? GlslTokenKind::Unclosed : GlslTokenKind::Blank;
  }

  GlslTokenKind number() {
    while (is_digit(next()) || is_letter(next()) || next() == '.') {
      const bool is_exponent = (next() == 'e' || next() == 'E') && !is_hexadecimal();
      if (is_exponent && (next(1) == '+' || next(1) == '-')) ++at_;
      ++at_;
    }
    return GlslTokenKind::Number;
  }

  bool is_hexadecimal() const {
    std::size_t begin = at_;
    while (begin > 0 && (is_letter(code_[begin - 1]) || is_digit(code_[begin - 1]))) --begin;
    return code_[begin] == '0' && begin + 1 < code_.size() && (code_[begin + 1] == 'x' || code_[begin + 1] == 'X');
  }

  std::string_view code_;
  std::size_t at_ = 0;
  uint32_t line_ = 0;
  bool at_line_begin_ = true;
  bool in_directive_ = false;
  std::vector<GlslToken> tokens_;
};

}  // namespace

std::vector<GlslToken> lex_glsl(std::string_view code) {
  return Lexer(code).run();
}

}  // namespace texbrdf::scene

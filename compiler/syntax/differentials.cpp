#include "syntax/differentials.h"

#include <algorithm>
#include <optional>

#include "syntax/brackets.h"

namespace texbrdf {
namespace {

constexpr uint32_t kNone = UINT32_MAX;
constexpr uint32_t kHighestOrder = 4;

/// What an integral may end with: `d` before a name, or the word `dx`.
enum class Spelling : uint8_t { None, Sign, Word };

/// Of what is open: an integral that looks for its differential, or a bracket.
struct Open {
  uint32_t token;
  bool is_integral;
};

class DifferentialSearch {
 public:
  DifferentialSearch(std::string_view text, std::pmr::vector<Token>& tokens) : text_(text), tokens_(tokens) {}

  void run() {
    pair_brackets();
    const auto end = static_cast<uint32_t>(tokens_.size() - 1);
    for (uint32_t token = 0; token < end; ++token) read(token);
    if (has_words_) split_words();
  }

 private:
  TokenKind kind(uint32_t token) const { return token < tokens_.size() ? tokens_[token].kind : TokenKind::End; }
  std::string_view text(uint32_t token) const {
    return text_.substr(tokens_[token].span.begin, tokens_[token].span.size());
  }

  void pair_brackets() {
    partners_.assign(tokens_.size(), kNone);
    std::vector<uint32_t> open;
    for (uint32_t token = 0; token < tokens_.size(); ++token) {
      if (is_opener(kind(token))) open.push_back(token);
      if (!is_closer(kind(token)) || open.empty()) continue;
      if (closer_of(kind(open.back())) == kind(token)) partners_[open.back()] = token;
      open.pop_back();
    }
  }

  void read(uint32_t token) {
    switch (kind(token)) {
      case TokenKind::Frac:
        return read_fraction(token);
      case TokenKind::OpenIntegral:
        return open_.push_back({token, true});
      case TokenKind::Equals:
      case TokenKind::Relation:
      case TokenKind::Comma:
        return give_up_integrals();
      default:
        break;
    }
    if (is_opener(kind(token))) {
      open_.push_back({token, false});
    } else if (is_closer(kind(token))) {
      give_up_integrals();
      if (!open_.empty()) open_.pop_back();
    } else if (!open_.empty() && spelling(token) != Spelling::None) {
      read_differential(token);
    }
  }

  /// What a bracket encloses, and what stands before a relation, is integrated in there.
  void give_up_integrals() {
    while (!open_.empty() && open_.back().is_integral) open_.pop_back();
  }

  void read_differential(uint32_t token) {
    if (open_.back().is_integral) {
      tokens_[open_.back().token].kind = TokenKind::Integral;
      open_.pop_back();
      mark(token, TokenKind::Differential);
      return;
    }
    const uint32_t brace = open_.back().token;
    const bool is_numerator = brace > 0 && kind(brace) == TokenKind::OpenBrace && kind(brace - 1) == TokenKind::Frac;
    if (!is_numerator || open_.size() < 2 || !open_[open_.size() - 2].is_integral) return;
    mark(token, TokenKind::DifferentialFactor);
    open_.erase(open_.end() - 2);
  }

  /// `\frac{d …}{dx}` and `\frac{\partial …}{\partial x}`.
  void read_fraction(uint32_t frac) {
    const uint32_t numerator = frac + 1;
    if (kind(numerator) != TokenKind::OpenBrace || partners_[numerator] == kNone) return;
    const uint32_t denominator = partners_[numerator] + 1;
    if (kind(denominator) != TokenKind::OpenBrace || partners_[denominator] == kNone) return;
    const uint32_t above = numerator + 1;
    const Order order = is_sign(above, true) ? order_at(above + 1) : Order{1, above + 1};
    if (order.times > 1) return read_higher_derivative(frac, order.times);
    const uint32_t below = denominator + 1;
    if (!begins_numerator(above) || spelling(below, true) == Spelling::None) return;
    if (!holds_one_name(below, partners_[denominator])) return;
    tokens_[frac].kind = TokenKind::DerivativeFrac;
    mark(above, TokenKind::Differential);
    mark(below, TokenKind::Differential);
  }

  /// `\frac{d^2 f}{dx^2}`, `\frac{\partial^2 f}{\partial x \partial y}`: above and below say the same order.
  void read_higher_derivative(uint32_t frac, uint32_t times) {
    const uint32_t denominator = partners_[frac + 1] + 1;
    const uint32_t end = partners_[denominator];
    std::vector<uint32_t> signs;
    uint32_t times_below = 0;
    for (uint32_t token = denominator + 1; token < end;) {
      if (spelling(token, true) == Spelling::None) return;
      signs.push_back(token++);
      while (token < end && kind(token) != TokenKind::Caret && spelling(token, true) == Spelling::None) ++token;
      if (!holds_one_name(signs.back(), token)) return;
      const Order order = order_at(token);
      times_below += order.times;
      token = order.behind;
    }
    if (times != times_below || times > kHighestOrder) return;
    tokens_[frac].kind = TokenKind::DerivativeFrac;
    mark(frac + 2, TokenKind::Differential);
    for (const uint32_t sign : signs) mark(sign, TokenKind::Differential);
  }

  struct Order {
    uint32_t times;
    uint32_t behind;
  };
  /// `^2` or `^{2}`; 1 where no power stands, 0 for any other.
  Order order_at(uint32_t token) const {
    if (kind(token) != TokenKind::Caret) return {1, token};
    const bool is_braced = kind(token + 1) == TokenKind::OpenBrace;
    const uint32_t number = token + (is_braced ? 2 : 1);
    const uint32_t behind = number + (is_braced ? 2 : 1);
    const bool is_digit_alone = kind(number) == TokenKind::Number && tokens_[number].span.size() == 1;
    if (!is_digit_alone || (is_braced && kind(number + 1) != TokenKind::CloseBrace)) return {0, behind};
    return {static_cast<uint32_t>(text(number)[0] - '0'), behind};
  }

  bool begins_numerator(uint32_t token) const {
    return spelling(token, true) != Spelling::None ||
           (is_sign(token, true) && (kind(token + 1) == TokenKind::CloseBrace || is_opener(kind(token + 1))));
  }

  /// `dx_1` and nothing else, so that `\frac{dL(x)}{dE(x)}` stays what it is.
  bool holds_one_name(uint32_t token, uint32_t end) const {
    return std::none_of(tokens_.begin() + token, tokens_.begin() + end, [](const Token& t) {
      return t.kind == TokenKind::OpenParen || t.kind == TokenKind::Caret || t.kind == TokenKind::Plus ||
             t.kind == TokenKind::Minus || t.kind == TokenKind::Multiply || t.kind == TokenKind::Divide;
    });
  }

  bool is_sign(uint32_t token, bool may_be_partial) const {
    const std::string_view sign = kind(token) == TokenKind::End ? std::string_view() : text(token);
    if (sign == "\\partial") return may_be_partial;
    if (kind(token) == TokenKind::Text) return is_upright_d(sign);
    return sign == "d" || sign == "\\dd" || sign == "\\diff" || sign == "\\differential";
  }

  /// `\mathrm{d}`, `\mathrm d`, `{\rm d}`.
  static bool is_upright_d(std::string_view token) {
    std::string_view inner = token;
    while (!inner.empty() && (inner.back() == '}' || inner.back() == ' ')) inner.remove_suffix(1);
    if (inner.size() < 2 || inner.back() != 'd') return false;
    const char before = inner[inner.size() - 2];
    return before == '{' || before == ' ';
  }

  Spelling spelling(uint32_t token, bool may_be_partial = false) const {
    const TokenKind before = token > 0 ? kind(token - 1) : TokenKind::End;
    if (before == TokenKind::Underscore || before == TokenKind::Caret) return Spelling::None;
    if (is_sign(token, may_be_partial)) {
      const TokenKind next = kind(token + 1);
      const bool is_name = next == TokenKind::Word || next == TokenKind::Macro || next == TokenKind::Text ||
                           next == TokenKind::Vec || next == TokenKind::Accent;
      return is_name ? Spelling::Sign : Spelling::None;
    }
    const bool is_word = kind(token) == TokenKind::Word && tokens_[token].span.size() == 2 && text(token)[0] == 'd';
    return is_word ? Spelling::Word : Spelling::None;
  }

  void mark(uint32_t token, TokenKind marked) {
    has_words_ = has_words_ || spelling(token, true) == Spelling::Word;
    tokens_[token].kind = marked;
  }

  /// `dx` becomes `d` and `x`.
  void split_words() {
    std::vector<Token> all;
    all.reserve(tokens_.size() + 16);
    for (const Token& token : tokens_) {
      all.push_back(token);
      const bool is_differential = token.kind == TokenKind::Differential || token.kind == TokenKind::DifferentialFactor;
      if (!is_differential || token.span.size() != 2 || text_[token.span.begin] != 'd') continue;
      const uint32_t letter = token.span.begin + 1;
      all.back().span.end = letter;
      all.push_back(token);
      all.back().kind = TokenKind::Word;
      all.back().span.begin = letter;
    }
    tokens_.assign(all.begin(), all.end());
  }

  std::string_view text_;
  std::pmr::vector<Token>& tokens_;
  std::vector<uint32_t> partners_;  // by token: of an opener
  std::vector<Open> open_;
  bool has_words_ = false;
};

}  // namespace

void mark_differentials(std::string_view text, std::pmr::vector<Token>& tokens) {
  const bool may_hold_some = std::ranges::any_of(tokens, [&](const Token& token) {
    return token.kind == TokenKind::OpenIntegral || token.kind == TokenKind::Frac;
  });
  if (may_hold_some) DifferentialSearch(text, tokens).run();
}

}  // namespace texbrdf

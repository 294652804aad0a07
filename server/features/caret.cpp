#include "features/caret.h"

#include <algorithm>
#include <array>

#include "semantics/name_traits.h"
#include "source/characters.h"
#include "syntax/brackets.h"
#include "syntax/control_words.h"

namespace texbrdf::features {
namespace {

using Role = OpenBracket::Role;
constexpr uint32_t kNone = UINT32_MAX;

/// What a bracket is behind a command.
struct RoleBehind {
  TokenKind before;
  Role role;
};
constexpr auto kRolesBehind = std::to_array<RoleBehind>({{TokenKind::Function, Role::Function},
                                                         {TokenKind::Extremum, Role::Extremum},
                                                         {TokenKind::Frac, Role::Numerator},
                                                         {TokenKind::DerivativeFrac, Role::Numerator},
                                                         {TokenKind::Sqrt, Role::Radicand},
                                                         {TokenKind::Caret, Role::Exponent}});

/// Reads tokens from the left and knows which brackets are open and where the name in front starts.
class BracketReader {
 public:
  explicit BracketReader(const ParsedBlock& block) : block_(block) {}

  void read_until(uint32_t token) {
    for (; next_ < token; ++next_) read(next_);
  }
  /// The first token of the name that ends, or goes on, at the next token; kNone where there is none.
  uint32_t name() const { return name_; }
  std::vector<OpenBracket> take() { return std::move(open_); }

 private:
  TokenKind kind(uint32_t token) const { return block_.tokens[token].kind; }
  /// Of the token in front; End at the block's start.
  TokenKind before(uint32_t token) const { return token == 0 ? TokenKind::End : kind(token - 1); }

  void read(uint32_t token) {
    const TokenKind here = kind(token);
    const bool goes_on = before(token) == TokenKind::Underscore || is_decoration(before(token));
    if (is_opener(here)) {
      open(token);
      name_ = kNone;
    } else if (is_closer(here)) {
      close(token);
    } else if (here == TokenKind::Word || here == TokenKind::Macro || here == TokenKind::Text || is_decoration(here)) {
      if (!goes_on || name_ == kNone) name_ = token;
    } else if (here == TokenKind::Underscore || here == TokenKind::Prime) {
      // The name goes on.
    } else if (goes_on && before(token) == TokenKind::Underscore) {
      // `x_1`, `x_+`: any one token may be a subscript.
    } else {
      if (here == TokenKind::Comma && !open_.empty()) ++open_.back().commas;
      name_ = kNone;
    }
  }

  void open(uint32_t token) {
    open_.push_back({.role = Role::Group, .token = token, .first_token = token});
    const bool is_brace = kind(token) == TokenKind::OpenBrace;
    if (is_brace) open_brace(token);
    if (const auto role = std::ranges::find(kRolesBehind, before(token), &RoleBehind::before);
        role != kRolesBehind.end()) {
      begin_with(token - 1, role->role);
    }
    if (before(token) == TokenKind::Sqrt && kind(token) == TokenKind::OpenBracket) open_.back().role = Role::RootIndex;
    if (kind(token) == TokenKind::OpenParen && name_ != kNone) begin_with(name_, Role::Call);
  }

  void open_brace(uint32_t token) {
    const TokenKind in_front = before(token);
    if (in_front == TokenKind::Underscore && name_ != kNone) {
      begin_with(name_, Role::Subscript);
    } else if (is_decoration(in_front)) {
      begin_with(name_, Role::Vec);
    } else if (in_front == TokenKind::Unknown && is_text_command(token - 1)) {
      begin_with(name_ == kNone ? token - 1 : name_, Role::Text);
    } else if (is_foreign_command(token)) {
      begin_with(token - 1, Role::Foreign);
    } else if (in_front == TokenKind::CloseBrace && closed_.role == Role::Numerator) {
      begin_with(closed_.first_token, Role::Denominator);
    } else if (in_front == TokenKind::CloseBracket && closed_.role == Role::RootIndex) {
      begin_with(closed_.first_token, Role::Radicand);
    }
  }

  void begin_with(uint32_t first_token, Role role) {
    open_.back().role = role;
    open_.back().first_token = first_token;
  }

  /// In front of the brace.
  bool is_foreign_command(uint32_t brace) const {
    if (before(brace) == TokenKind::Macro) return !is_greek(brace - 1);
    return before(brace) == TokenKind::Unknown && block_.token_text(brace - 1).starts_with('\\');
  }

  /// A closer without partner is passed over; openers without partner inside of a pair are closed with it.
  void close(uint32_t token) {
    name_ = kNone;
    closed_ = {};
    const auto partner = std::find_if(open_.rbegin(), open_.rend(), [&](const OpenBracket& bracket) {
      return closer_of(kind(bracket.token)) == kind(token);
    });
    if (partner == open_.rend()) return;
    closed_ = *partner;
    open_.erase(std::prev(partner.base()), open_.end());
    if (closed_.is_part_of_name()) name_ = closed_.first_token;
  }

  bool is_text_command(uint32_t token) const {
    const std::string_view text = block_.token_text(token);
    return text.starts_with('\\') && find_control_word(text.substr(1)).meaning == WordMeaning::Text;
  }
  bool is_greek(uint32_t token) const { return is_greek_letter(block_.token_text(token).substr(1)); }

  const ParsedBlock& block_;
  uint32_t next_ = 0;
  uint32_t name_ = kNone;
  OpenBracket closed_;
  std::vector<OpenBracket> open_;
};

class CaretReader {
 public:
  CaretReader(const ParsedBlock& block, uint32_t offset) : block_(block) { caret_.offset = offset; }

  std::optional<Caret> run() {
    caret_.word = {word_begin(), caret_.offset};
    const auto inside = token_around(caret_.word.begin);
    if (inside && block_.tokens[*inside].kind != TokenKind::Text) return std::nullopt;
    caret_.typed_token = inside ? *inside : first_token_behind(caret_.word.begin);
    if (!inside && is_in_ignored_group()) return std::nullopt;
    find_name(inside.has_value());
    if (!is_place_for_name(inside.has_value())) return std::nullopt;
    const auto tokens = std::span(block_.tokens).first(caret_.typed_token);
    caret_.is_left_side =
        std::ranges::none_of(tokens, [](const Token& token) { return token.kind == TokenKind::Equals; });
    return std::move(caret_);
  }

 private:
  /// Back over letters and the backslash in front of them, else over digits.
  uint32_t word_begin() const {
    const uint32_t first = block_.extent.content.begin;
    uint32_t begin = caret_.offset;
    while (begin > first && is_letter(block_.text[begin - 1])) --begin;
    uint32_t backslashes = 0;
    while (begin - backslashes > first && block_.text[begin - backslashes - 1] == '\\') ++backslashes;
    if (backslashes % 2 == 1) return begin - 1;
    if (begin < caret_.offset) return begin;
    while (begin > first && is_digit(block_.text[begin - 1])) --begin;
    return begin;
  }

  /// The token of which the offset is neither the first byte nor behind the last.
  std::optional<uint32_t> token_around(uint32_t offset) const {
    const uint32_t behind = first_token_behind(offset);
    if (behind == 0) return std::nullopt;
    const Span span = block_.tokens[behind - 1].span;
    return span.begin < offset && offset < span.end ? std::optional(behind - 1) : std::nullopt;
  }

  uint32_t first_token_behind(uint32_t offset) const {
    const auto behind = std::ranges::partition_point(
        block_.tokens, [&](const Token& token) { return token.span.begin < offset && token.kind != TokenKind::End; });
    return static_cast<uint32_t>(behind - block_.tokens.begin());
  }

  /// In the group of \label and the like, which makes no tokens.
  bool is_in_ignored_group() const {
    const uint32_t begin =
        caret_.typed_token == 0 ? block_.extent.content.begin : block_.tokens[caret_.typed_token - 1].span.end;
    std::string_view gap = block_.slice({begin, std::max(begin, caret_.word.begin)});
    gap.remove_prefix(gap.rfind('\n') + 1);  // of the caret's line; comments end with theirs
    const std::size_t opener = gap.rfind('{');
    return opener != std::string_view::npos && gap.find('}', opener) == std::string_view::npos;
  }

  /// `typed` starts where the name starts of which the word is a subscript or what it decorates.
  void find_name(bool is_in_text) {
    BracketReader reader(block_);
    reader.read_until(caret_.typed_token);
    const TokenKind before = caret_.typed_token == 0 ? TokenKind::End : block_.tokens[caret_.typed_token - 1].kind;
    const bool goes_on = before == TokenKind::Underscore || is_decoration(before);
    uint32_t first = goes_on && reader.name() != kNone ? reader.name() : caret_.typed_token;
    caret_.brackets = reader.take();
    const auto part = std::ranges::find_if(caret_.brackets, &OpenBracket::is_part_of_name);
    if (part != caret_.brackets.end()) {
      first = part->first_token;
      is_foreign_ = std::any_of(part, caret_.brackets.end(), is_foreign);
      caret_.brackets.erase(part, caret_.brackets.end());
    }
    const bool starts_in_front = first < caret_.typed_token || is_in_text;
    is_subscript_ = first < caret_.typed_token;
    caret_.typed = {starts_in_front ? block_.tokens[first].span.begin : caret_.word.begin, caret_.offset};
    caret_.typed_token = first;
  }

  static bool is_foreign(const OpenBracket& bracket) { return bracket.role == Role::Foreign; }

  bool is_place_for_name(bool is_in_text) const {
    if (is_foreign_ || std::ranges::any_of(caret_.brackets, is_foreign)) return false;
    if (is_behind_ignored_word()) return false;
    if (block_.slice(caret_.typed).find_first_of("\r\n") != std::string_view::npos) return false;
    const std::string_view word = block_.slice(caret_.word);
    if (!word.empty() && is_digit(word.front())) return is_subscript_ || is_in_text;
    const bool follows_point = caret_.word.empty() && caret_.offset > 0 && block_.text[caret_.offset - 1] == '.';
    return !follows_point;
  }

  /// `\label{eq:` that nobody has closed yet: its brace has become a token.
  bool is_behind_ignored_word() const {
    return std::ranges::any_of(caret_.brackets, [&](const OpenBracket& bracket) {
      if (bracket.role != Role::Group) return false;
      std::string_view text = block_.slice({block_.extent.content.begin, block_.tokens[bracket.token].span.begin});
      while (text.ends_with(' ') || text.ends_with('*')) text.remove_suffix(1);
      const std::size_t backslash = text.rfind('\\');
      if (backslash == std::string_view::npos) return false;
      return find_control_word(text.substr(backslash + 1)).meaning == WordMeaning::NothingWithGroup;
    });
  }

  const ParsedBlock& block_;
  Caret caret_;
  bool is_foreign_ = false;
  bool is_subscript_ = false;
};

}  // namespace

std::optional<MathPlace> math_place(const Snapshot& snapshot, uint32_t offset) {
  const auto block = snapshot.block_at(offset);
  if (!block) return std::nullopt;
  const ParsedBlock& parsed = snapshot.parsed(*block);
  const std::optional<uint32_t> in_text = parsed.from_source(offset - snapshot.absolute(*block, {}).begin);
  if (!in_text) return std::nullopt;
  const uint32_t relative = *in_text;
  const bool is_in_comment = std::ranges::any_of(
      parsed.comments, [&](Span comment) { return comment.begin < relative && relative <= comment.end; });
  const bool is_read = parsed.extent.content.touches(relative) && parsed.text.size() <= kMaxBlockBytes;
  if (!is_read || is_in_comment) return std::nullopt;
  const auto behind = std::ranges::partition_point(parsed.tokens, [relative](const Token& token) {
    return token.span.end <= relative && token.kind != TokenKind::End;
  });
  return MathPlace{*block, relative, static_cast<uint32_t>(behind - parsed.tokens.begin())};
}

std::optional<Caret> find_caret(const Snapshot& snapshot, uint32_t offset) {
  const auto place = math_place(snapshot, offset);
  if (!place) return std::nullopt;
  auto caret = CaretReader(snapshot.parsed(place->block), place->offset).run();
  // What stands at the end of a macro, or of its argument, is no word that somebody types.
  if (caret && !snapshot.parsed(place->block).is_replaceable(caret->typed)) return std::nullopt;
  if (caret && snapshot.absolute(place->block, caret->typed).end != offset) return std::nullopt;
  if (caret) caret->block = place->block;
  return caret;
}

std::vector<OpenBracket> open_brackets(const ParsedBlock& block, uint32_t token) {
  BracketReader reader(block);
  reader.read_until(token);
  return reader.take();
}

}  // namespace texbrdf::features

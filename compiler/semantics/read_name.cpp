#include <algorithm>

#include "semantics/name_spelling.h"
#include "semantics/names.h"
#include "source/characters.h"

namespace texbrdf {
namespace {

/// Reads the tokens of a name, of which the parser has seen that they are one.
class NameReader {
 public:
  NameReader(const ParsedBlock& block, uint32_t first, uint32_t end) : block_(block), token_(first), end_(end) {}

  Name read() {
    name_.is_in_angles = kind() == TokenKind::OpenAngle;
    if (name_.is_in_angles) {
      ++token_;
      --end_;
    }
    read_decorated();
    return std::move(name_);
  }

 private:
  bool at_end() const { return token_ >= end_; }
  TokenKind kind() const { return at_end() ? TokenKind::End : block_.tokens[token_].kind; }

  /// Decorations and braces may alternate; all that is behind the base belongs to it, wherever a brace closes.
  void read_decorated() {
    for (;
         kind() == TokenKind::Vec || kind() == TokenKind::Accent || kind() == TokenKind::OpenBrace || is_layout(kind());
         ++token_) {
      if (kind() == TokenKind::Vec || kind() == TokenKind::Accent) add_decoration();
    }
    if (!at_end()) read_base();
    while (!at_end()) read_behind_base();
  }

  /// One vector's decoration in another says nothing more.
  void add_decoration() {
    const std::string_view decoration = decoration_name(block_, token_);
    const bool is_double = !name_.decorations.empty() && decoration == "vec" && name_.decorations.back() == decoration;
    if (!is_double) name_.decorations.emplace_back(decoration);
  }

  void read_base() {
    const std::string_view text = block_.token_text(token_);
    name_.is_text = kind() == TokenKind::Text;
    name_.is_command = kind() == TokenKind::Macro;
    if (name_.is_text) {
      name_.base = read_text_token(text);
    } else {
      name_.base = name_.is_command ? text.substr(1) : text;
    }
    ++token_;
  }

  void read_behind_base() {
    if (kind() == TokenKind::Prime) ++name_.primes;
    if (is_label()) return read_label();
    if (kind() == TokenKind::Plus) name_.subscripts.emplace_back("+");
    if (kind() != TokenKind::Underscore) {
      ++token_;
      return;
    }
    const uint32_t first = token_ + 1;
    token_ = behind_argument(block_, first, end_);
    name_.subscripts.push_back(normal_tokens(block_, first, token_));
  }

  bool is_label() const {
    return kind() == TokenKind::Caret && token_ + kLabelTokens <= end_ &&
           block_.tokens[token_ + 2].kind == TokenKind::OpenParen;
  }

  void read_label() {
    name_.label = normal_tokens(block_, token_ + 3, token_ + 4);
    token_ += kLabelTokens;
  }

  static constexpr uint32_t kLabelTokens = 6;  // ^{(1)}

  const ParsedBlock& block_;
  uint32_t token_;
  uint32_t end_;
  Name name_;
};

std::string spelled_base(const Name& name) {
  if (name.is_text) return spell_text(name.base);
  return name.is_command ? "\\" + name.base : name.base;
}

/// The first subscript stands inside all decorations, as in \vec{x_1}; further ones one brace farther out each.
std::string spelled(const Name& name) {
  std::string text;
  for (const std::string& decoration : name.decorations) text.append("\\").append(decoration) += '{';
  text += spelled_base(name);
  const size_t levels = std::max(name.subscripts.size(), name.decorations.size());
  for (size_t level = 0; level < levels; ++level) {
    if (level < name.subscripts.size()) text += subscript_suffix(name.subscripts[level]);
    if (level < name.decorations.size()) text += '}';
  }
  text.append(name.primes, '\'');
  return name.label.empty() ? text : text + "^{(" + name.label + ")}";
}

}  // namespace

Name read_name(const ParsedBlock& block, NodeId id) {
  const Node& node = block.tree.node(id);
  return NameReader(block, node.first_token, node.end_token).read();
}

std::string shown_name(std::string_view canonical) {
  constexpr size_t kLongest = 100;
  if (canonical.size() <= kLongest) return std::string(canonical);
  size_t end = kLongest;
  const auto is_continuation = [&](size_t i) { return (static_cast<unsigned char>(canonical[i]) & 0xc0) == 0x80; };
  while (end > 0 && is_continuation(end)) --end;
  return std::string(canonical.substr(0, end)) + "…";
}

std::string shown_spelling(std::string_view source, std::string_view canonical) {
  constexpr size_t kLongest = 40;
  const bool is_decorated = canonical.starts_with("\\vec{") || canonical == kStepFunction;
  const bool is_plain_line = source.size() <= kLongest && source.find_first_of("\r\n\t%&") == std::string_view::npos;
  return is_decorated && is_plain_line ? std::string(source) : shown_name(canonical);
}

std::string canonical_form(const Name& name) {
  std::string text = spelled(name);
  if (name.is_in_angles) return (is_letter(text.front()) ? "\\langle " : "\\langle") + text + "\\rangle";
  if (name.is_hat_apart) return "\\hat{" + text + "}";
  if (const std::optional<Convention> convention = find_convention(text)) {
    return std::string(convention_entry(*convention).spellings.front());
  }
  return text;
}

}  // namespace texbrdf

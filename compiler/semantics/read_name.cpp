#include <algorithm>

#include "semantics/name_spelling.h"
#include "semantics/names.h"

namespace texbrdf {
namespace {

struct Subscript {
  std::string text;
  uint32_t end;  // the token behind it
};

// `token` is the underscore.
Subscript read_subscript(const ParsedBlock& block, uint32_t token, uint32_t end) {
  const uint32_t first = token + 1;
  if (first >= end) return {{}, end};
  switch (block.tokens[first].kind) {
    case TokenKind::OpenBrace: {
      const uint32_t behind = behind_closer(block, first, end);
      return {normal_tokens(block, first, behind), behind};
    }
    case TokenKind::Vec: {
      const uint32_t behind = behind_closer(block, std::min(first + 1, end), end);
      return {normal_tokens(block, first, behind), behind};
    }
    default:
      return {normal_tokens(block, first, first + 1), first + 1};
  }
}

void read_base(const ParsedBlock& block, uint32_t token, Name& name) {
  const std::string_view text = block.token_text(token);
  switch (block.tokens[token].kind) {
    case TokenKind::Text: {
      TextToken read = read_text_token(text);
      name.decoration = read.is_roman ? Decoration::Roman : Decoration::Text;
      name.base = std::move(read.content);
      break;
    }
    case TokenKind::Macro:
      name.is_command = true;
      name.base = text.substr(1);
      break;
    default:
      name.base = text;
      break;
  }
}

Name read_tokens(const ParsedBlock& block, uint32_t first, uint32_t end);

uint32_t read_vec(const ParsedBlock& block, uint32_t vec, uint32_t end, Name& name) {
  const uint32_t open = vec + 1;
  const uint32_t behind = behind_closer(block, open, end);
  // Decorations in decorations are told by their spelling alone: only the innermost name is read.
  uint32_t first = open + 1;
  uint32_t last = behind > first ? behind - 1 : first;
  uint32_t depth = 1;
  while (first + 1 < last && block.tokens[first].kind == TokenKind::Vec) {
    first += 2;
    ++depth;
  }
  const uint32_t innermost_end = depth == 1 ? last : behind_closer(block, first - 1, last) - 1;
  name = read_tokens(block, first, std::max(first, innermost_end));
  name.inner = {depth == 1 ? canonical_form(name) : normal_tokens(block, open + 1, last)};
  name.decoration = Decoration::Vec;
  name.subscripts_inside = static_cast<uint32_t>(name.subscripts.size());
  return behind;
}

// A subscript behind \vec{x} belongs to what is decorated: \vec{x}_1 is \vec{x_1}.
void move_subscript_inside(Name& name) {
  if (name.decoration != Decoration::Vec || name.subscripts_inside > 0 || name.subscripts.empty()) return;
  name.inner.front() += subscript_suffix(name.subscripts.front());
  name.subscripts_inside = 1;
}

Name read_tokens(const ParsedBlock& block, uint32_t first, uint32_t end) {
  Name name;
  if (first >= end) return name;
  uint32_t token = first;
  if (block.tokens[first].kind == TokenKind::Vec && first + 1 < end) {
    token = read_vec(block, first, end, name);
  } else {
    read_base(block, first, name);
    ++token;
  }
  while (token < end && block.tokens[token].kind == TokenKind::Underscore) {
    Subscript subscript = read_subscript(block, token, end);
    name.subscripts.push_back(std::move(subscript.text));
    token = subscript.end;
  }
  move_subscript_inside(name);
  return name;
}

std::string undecorated_base(const Name& name) {
  switch (name.decoration) {
    case Decoration::Text:
      return spell_text({false, name.base});
    case Decoration::Roman:
      return spell_text({true, name.base});
    case Decoration::None:
    case Decoration::Vec:
      break;
  }
  return name.is_command ? "\\" + name.base : name.base;
}

std::string spelled(const Name& name) {
  std::string text;
  size_t next = 0;
  if (name.decoration == Decoration::Vec) {
    const bool has_inner = !name.inner.empty();
    text = "\\vec{" + (has_inner ? name.inner.front() : undecorated_base(name));
    if (has_inner) next = name.subscripts_inside;
    if (!has_inner && !name.subscripts.empty()) text += subscript_suffix(name.subscripts[next++]);
    text += '}';
  } else {
    text = undecorated_base(name);
  }
  for (; next < name.subscripts.size(); ++next) text += subscript_suffix(name.subscripts[next]);
  return text.append(name.primes, '\'');
}

}  // namespace

Name read_name(const ParsedBlock& block, NodeId id) {
  const Node& node = block.tree.node(id);
  return read_tokens(block, node.first_token, node.end_token);
}

std::string shown_name(std::string_view canonical) {
  constexpr size_t kLongest = 100;
  if (canonical.size() <= kLongest) return std::string(canonical);
  size_t end = kLongest;
  const auto is_continuation = [&](size_t i) { return (static_cast<unsigned char>(canonical[i]) & 0xc0) == 0x80; };
  while (end > 0 && is_continuation(end)) --end;
  return std::string(canonical.substr(0, end)) + "…";
}

std::string canonical_form(const Name& name) {
  std::string text = spelled(name);
  if (const std::optional<Convention> convention = find_convention(text)) {
    return std::string(convention_entry(*convention).spellings.front());
  }
  return text;
}

}  // namespace texbrdf

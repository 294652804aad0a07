#include "semantics/name_spelling.h"

#include <algorithm>
#include <vector>

namespace texbrdf {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

bool is_control_word(std::string_view text) {
  return text.size() > 1 && text.front() == '\\' && std::all_of(text.begin() + 1, text.end(), is_letter);
}

bool is_one_symbol(std::string_view text) {
  return text.size() == 1 || is_control_word(text);
}

class NormalForm {
 public:
  explicit NormalForm(const ParsedBlock& block) : block_(block) {}

  std::string read(uint32_t first, uint32_t end) {
    for (uint32_t token = first; token < end; ++token) read_token(token);
    while (!open_.empty()) close();
    return std::move(out_);
  }

 private:
  enum class Opened : uint8_t {
    Plain,      // braces that only group: dropped
    Vec,        // \vec{: kept
    Subscript,  // _{: kept around more than one symbol
    Single,     // the one symbol behind _
  };
  struct Frame {
    Opened opened;
    size_t content;
  };

  void read_token(uint32_t token) {
    switch (block_.tokens[token].kind) {
      case TokenKind::Underscore:
        out_ += '_';
        after_command_ = false;
        expects_subscript_ = true;
        break;
      case TokenKind::Vec:
        begin_symbol();
        out_ += "\\vec";
        after_vec_ = true;
        after_command_ = false;
        break;
      case TokenKind::OpenBrace:
        open_brace();
        break;
      case TokenKind::CloseBrace:
        close();
        break;
      case TokenKind::Text:
        begin_symbol();
        append(spell_text(read_text_token(block_.token_text(token))));
        end_symbol();
        break;
      default:
        begin_symbol();
        append(block_.token_text(token));
        end_symbol();
        break;
    }
  }

  void open_brace() {
    const Opened opened = after_vec_ ? Opened::Vec : expects_subscript_ ? Opened::Subscript : Opened::Plain;
    if (opened != Opened::Plain) out_ += '{';
    after_vec_ = false;
    expects_subscript_ = false;
    open_.push_back({opened, out_.size()});
  }

  void begin_symbol() {
    if (!expects_subscript_) return;
    expects_subscript_ = false;
    out_ += '{';
    open_.push_back({Opened::Single, out_.size()});
  }

  void end_symbol() {
    after_vec_ = false;
    if (!open_.empty() && open_.back().opened == Opened::Single) close();
  }

  void append(std::string_view text) {
    if (after_command_ && !text.empty() && is_letter(text.front())) out_ += ' ';
    out_ += text;
    after_command_ = is_control_word(text);
  }

  void close() {
    if (open_.empty()) return;
    const Frame frame = open_.back();
    open_.pop_back();
    if (frame.opened == Opened::Plain) return;
    const std::string_view content = std::string_view(out_).substr(frame.content);
    const bool is_bare = frame.opened != Opened::Vec && is_one_symbol(content);
    after_command_ = is_bare && is_control_word(content);
    if (is_bare) {
      out_.erase(frame.content - 1, 1);
    } else {
      out_ += '}';
    }
    if (frame.opened == Opened::Vec) end_symbol();
  }

  const ParsedBlock& block_;
  std::string out_;
  std::vector<Frame> open_;
  bool expects_subscript_ = false;
  bool after_vec_ = false;
  bool after_command_ = false;  // a letter would become part of the command before it
};

// `\_` as `_`, white space folded (in \text) or dropped (in \mathrm, where TeX ignores it).
std::string unescape(std::string_view content, bool keep_spaces) {
  std::string out;
  bool pending_space = false;
  for (size_t i = 0; i < content.size(); ++i) {
    if (is_space(content[i])) {
      pending_space = keep_spaces && !out.empty();
      continue;
    }
    if (pending_space) out += ' ';
    pending_space = false;
    if (content.substr(i).starts_with("\\_")) ++i;
    out += content[i];
  }
  return out;
}

}  // namespace

std::string normal_tokens(const ParsedBlock& block, uint32_t first, uint32_t end) {
  return NormalForm(block).read(first, end);
}

std::string subscript_suffix(std::string_view subscript) {
  std::string suffix = "_";
  if (is_one_symbol(subscript)) return suffix.append(subscript);
  return suffix.append("{").append(subscript).append("}");
}

TextToken read_text_token(std::string_view token) {
  const size_t open = std::min(token.find('{'), token.size());
  const bool is_roman = token.starts_with("\\mathrm");
  std::string_view content = token.substr(std::min(open + 1, token.size()));
  if (content.ends_with('}')) content.remove_suffix(1);
  return {is_roman, unescape(content, !is_roman)};
}

std::string spell_text(const TextToken& text) {
  std::string out = text.is_roman ? "\\mathrm{" : "\\text{";
  for (char c : text.content) {
    if (c == '_') out += '\\';
    out += c;
  }
  return out += '}';
}

uint32_t behind_closer(const ParsedBlock& block, uint32_t open, uint32_t end) {
  uint32_t depth = 0;
  for (uint32_t token = open; token < end; ++token) {
    const TokenKind kind = block.tokens[token].kind;
    if (kind == TokenKind::OpenBrace) ++depth;
    if (kind == TokenKind::CloseBrace && --depth == 0) return token + 1;
  }
  return end;
}

}  // namespace texbrdf

#include "semantics/name_spelling.h"

#include <algorithm>
#include <vector>

#include "source/characters.h"

namespace texbrdf {
namespace {

bool is_control_word(std::string_view text) {
  return text.size() > 1 && text.front() == '\\' && std::all_of(text.begin() + 1, text.end(), is_letter);
}

bool is_one_symbol(std::string_view text) {
  return text.size() == 1 || is_control_word(text);
}

bool is_letter_or_digit(char c) {
  return is_letter(c) || is_digit(c);
}

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

class NormalForm {
 public:
  explicit NormalForm(const ParsedBlock& block) : block_(block) {}

  std::string read(uint32_t first, uint32_t end) {
    for (uint32_t token = first; token < end; ++token) read_token(token);
    leave_undecorated();
    while (!open_.empty()) close();
    return std::move(out_);
  }

 private:
  enum class Opened : uint8_t {
    Plain,            // braces that only group: dropped
    Decoration,       // \vec{: kept
    DecoratedSymbol,  // the one symbol behind \vec
    Subscript,        // _{: kept around more than one symbol
    Single,           // the one symbol behind _
  };
  struct Frame {
    Opened opened;
    size_t content;
    bool is_vec = false;
  };

  void read_token(uint32_t token) {
    switch (block_.tokens[token].kind) {
      case TokenKind::Underscore:
        out_ += '_';
        after_command_ = false;
        expects_subscript_ = true;
        break;
      case TokenKind::Vec:
      case TokenKind::Accent:
        decorate(decoration_name(block_, token), block_.tokens[token].kind == TokenKind::Vec);
        break;
      case TokenKind::OpenBrace:
        open_brace();
        break;
      case TokenKind::CloseBrace:
        close();
        break;
      case TokenKind::Text:
        begin_symbol();
        append_text(read_text_token(block_.token_text(token)));
        end_symbol();
        break;
      case TokenKind::Word:
        begin_symbol();
        append_word(block_.token_text(token));
        end_symbol();
        break;
      case TokenKind::Prime:
        out_ += '\'';
        after_command_ = false;
        break;
      default:
        begin_symbol();
        append(block_.token_text(token));
        end_symbol();
        break;
    }
  }

  /// A vector's decoration straight inside of another says nothing more.
  void decorate(std::string_view name, bool is_vec) {
    const bool is_first_inside = !open_.empty() && open_.back().is_vec && open_.back().content == out_.size();
    if (is_vec && (awaits_decorated_vec_ || is_first_inside)) return;
    begin_symbol();
    out_.append("\\").append(name) += '{';
    awaits_decorated_ = true;
    awaits_decorated_vec_ = is_vec;
    after_command_ = false;
  }

  void open_brace() {
    Opened opened = Opened::Plain;
    if (awaits_decorated_) {
      opened = Opened::Decoration;
    } else if (expects_subscript_) {
      opened = Opened::Subscript;
      out_ += '{';
    }
    open_.push_back({opened, out_.size(), awaits_decorated_vec_});
    awaits_decorated_ = awaits_decorated_vec_ = expects_subscript_ = false;
  }

  void begin_symbol() {
    if (awaits_decorated_) {
      open_.push_back({Opened::DecoratedSymbol, out_.size(), awaits_decorated_vec_});
      awaits_decorated_ = awaits_decorated_vec_ = false;
    } else if (expects_subscript_) {
      expects_subscript_ = false;
      out_ += '{';
      open_.push_back({Opened::Single, out_.size()});
    }
  }

  void end_symbol() {
    const auto is_one_symbol_long = [](const Frame& frame) {
      return frame.opened == Opened::Single || frame.opened == Opened::DecoratedSymbol;
    };
    if (!open_.empty() && is_one_symbol_long(open_.back())) close();
  }

  void append(std::string_view text) {
    if (after_command_ && !text.empty() && is_letter(text.front())) out_ += ' ';
    out_ += text;
    after_command_ = is_control_word(text);
  }

  /// `cook\_torrance` is the word in any font.
  void append_word(std::string_view word) {
    const bool is_joined = word.find('\\') != std::string_view::npos;
    if (is_joined) return append_text(unescape(word, true));
    append(word);
  }

  /// Upright letters and digits are as good as others here: `\rho_{\text{diff}}` is `\rho_{diff}`.
  void append_text(const std::string& content) {
    const bool is_plain = !content.empty() && std::ranges::all_of(content, is_letter_or_digit);
    append(is_plain ? content : spell_text(content));
  }

  /// A decoration of nothing.
  void leave_undecorated() {
    if (awaits_decorated_) out_ += '}';
    awaits_decorated_ = awaits_decorated_vec_ = false;
  }

  void close() {
    leave_undecorated();
    if (open_.empty()) return;
    const Frame frame = open_.back();
    open_.pop_back();
    if (frame.opened == Opened::Plain) return;
    const bool is_decoration = frame.opened == Opened::Decoration || frame.opened == Opened::DecoratedSymbol;
    const std::string_view content = std::string_view(out_).substr(frame.content);
    const bool is_bare = !is_decoration && is_one_symbol(content);
    after_command_ = is_bare && is_control_word(content);
    if (is_bare) {
      out_.erase(frame.content - 1, 1);
    } else {
      out_ += '}';
    }
    if (is_decoration) end_symbol();
  }

  const ParsedBlock& block_;
  std::string out_;
  std::vector<Frame> open_;
  bool expects_subscript_ = false;
  bool awaits_decorated_ = false;  // a decoration stands in front
  bool awaits_decorated_vec_ = false;
  bool after_command_ = false;  // a letter would become part of the command before it
};

}  // namespace

std::string normal_tokens(const ParsedBlock& block, uint32_t first, uint32_t end) {
  return NormalForm(block).read(first, end);
}

std::string subscript_suffix(std::string_view subscript) {
  std::string suffix = "_";
  if (is_one_symbol(subscript)) return suffix.append(subscript);
  return suffix.append("{").append(subscript).append("}");
}

std::string read_text_token(std::string_view token) {
  constexpr std::string_view kKeepSpaces[] = {"text", "mbox"};  // \text, \textit … and \mbox
  const size_t command = std::min(token.find('\\'), token.size() - 1) + 1;
  size_t begin = command;
  while (begin < token.size() && is_letter(token[begin])) ++begin;
  const std::string_view word = token.substr(command, begin - command);
  const bool keep_spaces = std::ranges::any_of(kKeepSpaces, [&](auto known) { return word.starts_with(known); });
  std::string_view content = token.substr(begin);
  if (content.starts_with('*')) content.remove_prefix(1);
  while (!content.empty() && is_space(content.front())) content.remove_prefix(1);
  if (content.starts_with('{')) content.remove_prefix(1);
  if (content.ends_with('}')) content.remove_suffix(1);
  return unescape(content, keep_spaces);
}

std::string spell_text(std::string_view content) {
  std::string out = "\\text{";
  for (char c : content) {
    if (c == '_') out += '\\';
    out += c;
  }
  return out += '}';
}

std::string_view decoration_name(const ParsedBlock& block, uint32_t token) {
  return block.tokens[token].kind == TokenKind::Vec ? "vec" : block.token_text(token).substr(1);
}

uint32_t behind_argument(const ParsedBlock& block, uint32_t token, uint32_t end) {
  while (token < end && is_decoration(block.tokens[token].kind)) ++token;
  if (token >= end) return end;
  return block.tokens[token].kind == TokenKind::OpenBrace ? behind_closer(block, token, end) : token + 1;
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

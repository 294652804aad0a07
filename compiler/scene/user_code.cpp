#include "scene/user_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "scene/glsl_lexer.h"

namespace texbrdf::scene {
namespace {

struct SlangWord {
  std::string_view word;
  std::string_view glsl;
};

constexpr std::array kSlangWords{
#define SLANG_WORD(word, glsl) SlangWord{word, glsl},
#include "scene/slang_words.def"
#undef SLANG_WORD
};

/// Words that can stand before a name or `;` without declaring the name that they are.
constexpr std::array<std::string_view, 10> kNoNames = {"float", "int",  "uint", "bool",  "void",
                                                       "vec2",  "vec3", "vec4", "const", "struct"};

bool is_word(const GlslToken& token, std::string_view text) {
  return token.kind == GlslTokenKind::Word && token.text == text;
}

bool is_sign(const GlslToken& token, char sign) {
  return token.kind == GlslTokenKind::Sign && token.text.front() == sign;
}

bool is_any_sign(const GlslToken& token, std::string_view signs) {
  return token.kind == GlslTokenKind::Sign && signs.find(token.text.front()) != std::string_view::npos;
}

/// Tokens without blanks, with how deep in brackets each stands.
struct CodeTokens {
  std::vector<GlslToken> all;
  std::vector<std::size_t> solid;  ///< indices of those that are no blanks

  explicit CodeTokens(std::string_view code) : all(lex_glsl(code)) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].kind != GlslTokenKind::Blank) solid.push_back(i);
    }
  }
  const GlslToken& operator[](std::size_t i) const {
    static const GlslToken kNone;
    return i < solid.size() ? all[solid[i]] : kNone;
  }
  std::size_t size() const { return solid.size(); }
};

/// The names that code declares outside of functions, and the tokens that name a field of a struct.
struct Declared {
  std::set<std::string_view> names;
  std::set<std::size_t> fields;  ///< indices into CodeTokens::solid
  std::map<std::string_view, std::string_view> types;
};

class DeclarationFinder {
 public:
  explicit DeclarationFinder(const CodeTokens& tokens) : tokens_(tokens) {}

  Declared run() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) step();
    return std::move(found_);
  }

 private:
  void step() {
    const GlslToken& token = tokens_[at_];
    if (token.in_directive) {
      if (is_word(token, "define") && at_ > 0 && is_sign(tokens_[at_ - 1], '#'))
        found_.names.insert(tokens_[at_ + 1].text);
      return;
    }
    if (is_any_sign(token, "({[")) {
      ++depth_;
      if (is_sign(token, '{') && struct_depth_ == 0 && opens_struct()) struct_depth_ = depth_;
    } else if (is_any_sign(token, ")}]")) {
      if (struct_depth_ == depth_) struct_depth_ = 0;
      --depth_;
    } else if (token.kind == GlslTokenKind::Word) {
      if (depth_ == 0) name();
      if (struct_depth_ > 0 && is_any_sign(tokens_[at_ + 1], ";,[")) found_.fields.insert(at_);
    }
  }

  bool opens_struct() const {
    return at_ >= 1 && (is_word(tokens_[at_ - 1], "struct") || (at_ >= 2 && is_word(tokens_[at_ - 2], "struct")));
  }

  void name() {
    const std::string_view text = tokens_[at_].text;
    if (std::ranges::find(kNoNames, text) != kNoNames.end() || at_ == 0) return;
    const GlslToken& before = tokens_[at_ - 1];
    const bool can_follow = before.kind == GlslTokenKind::Word || is_any_sign(before, ",]}");
    const bool is_struct = is_word(before, "struct");
    if (!is_struct && !(can_follow && is_any_sign(tokens_[at_ + 1], "(;=,["))) return;
    found_.names.insert(text);
    if (before.kind == GlslTokenKind::Word) found_.types.try_emplace(text, before.text);
  }

  const CodeTokens& tokens_;
  Declared found_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int struct_depth_ = 0;  // 0 outside of structs
};

std::string_view in_glsl(std::string_view word) {
  const auto* const found = std::ranges::find(kSlangWords, word, &SlangWord::word);
  return found == kSlangWords.end() ? word : found->glsl;
}

}  // namespace

std::optional<CodeFault> find_code_fault(const UserPrimitive& /*primitive*/) {
  return std::nullopt;
}

std::optional<CodeFault> find_code_fault(const Shader& /*shader*/) {
  return std::nullopt;
}

std::string with_prefix(std::string_view code, std::string_view prefix) {
  const CodeTokens tokens(code);
  const Declared declared = DeclarationFinder(tokens).run();
  std::string text;
  std::size_t solid = 0;
  for (const GlslToken& token : tokens.all) {
    if (token.kind == GlslTokenKind::Blank) {
      text += token.text;
      continue;
    }
    const std::size_t at = solid++;
    const bool is_field = declared.fields.contains(at) || (at > 0 && is_sign(tokens[at - 1], '.'));
    const bool is_directive = token.in_directive && at > 0 && is_sign(tokens[at - 1], '#');
    if (token.kind != GlslTokenKind::Word || is_field || is_directive) {
      text += token.text;
    } else if (declared.names.contains(token.text)) {
      text += prefix;
      text += token.text;
    } else if (token.text != "uniform") {
      text += in_glsl(token.text);
    }
  }
  return text;
}

bool has_word(std::string_view code, std::string_view word) {
  return std::ranges::any_of(lex_glsl(code), [&](const GlslToken& token) { return is_word(token, word); });
}

}  // namespace texbrdf::scene

#include "scene/user_code.h"

#include <algorithm>
#include <array>

#include "scene/glsl_declarations.h"

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

}  // namespace

std::string_view in_glsl(std::string_view word) {
  const auto* const found = std::ranges::find(kSlangWords, word, &SlangWord::word);
  return found == kSlangWords.end() ? word : found->glsl;
}

std::string with_prefix(std::string_view code, std::string_view prefix) {
  const CodeTokens tokens(code);
  const Declarations declared = find_declarations(tokens);
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
    } else if (declared.has(token.text)) {
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

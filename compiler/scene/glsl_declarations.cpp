#include "scene/glsl_declarations.h"

#include <algorithm>
#include <array>
#include <optional>

namespace texbrdf::scene {
namespace {

/// Words that stand where a name could and are none.
constexpr std::array<std::string_view, 10> kNoNames = {"float", "int",  "uint", "bool",  "void",
                                                       "vec2",  "vec3", "vec4", "const", "struct"};

class DeclarationFinder {
 public:
  explicit DeclarationFinder(const CodeTokens& tokens) : tokens_(tokens) {}

  Declarations run() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) step();
    return std::move(found_);
  }

 private:
  void step() {
    const GlslToken& token = tokens_[at_];
    if (token.in_directive) {
      directive(token);
    } else if (is_any_sign(token, "({[")) {
      ++depth_;
      if (is_sign(token, '{') && struct_depth_ == 0 && opens_struct()) struct_depth_ = depth_;
    } else if (is_any_sign(token, ")}]")) {
      if (struct_depth_ == depth_) struct_depth_ = 0;
      --depth_;
    } else if (token.kind == GlslTokenKind::Word) {
      if (depth_ == 0) name(token);
      if (struct_depth_ > 0 && is_any_sign(tokens_[at_ + 1], ";,[")) found_.fields.insert(at_);
    }
  }

  /// Each branch of a conditional begins as deep as the first, and what follows is as deep as the first left it.
  void directive(const GlslToken& token) {
    if (at_ >= 2 && is_word(tokens_[at_ - 1], "define") && is_sign(tokens_[at_ - 2], '#'))
      found_.names[token.text] = {DeclaredKind::Macro, {}, token.line};
    if (at_ == 0 || !is_sign(tokens_[at_ - 1], '#')) return;
    if (token.text.starts_with("if")) conditionals_.push_back({depth_, {}});
    if (conditionals_.empty() || !token.text.starts_with('e')) return;
    Conditional& conditional = conditionals_.back();
    if (!conditional.behind) conditional.behind = depth_;
    depth_ = token.text == "endif" ? *conditional.behind : conditional.before;
    if (token.text == "endif") conditionals_.pop_back();
  }

  bool opens_struct() const {
    return at_ >= 1 && (is_word(tokens_[at_ - 1], "struct") || (at_ >= 2 && is_word(tokens_[at_ - 2], "struct")));
  }

  void name(const GlslToken& token) {
    if (std::ranges::find(kNoNames, token.text) != kNoNames.end() || at_ == 0) return;
    const GlslToken& before = tokens_[at_ - 1];
    const GlslToken& behind = tokens_[at_ + 1];
    if (is_word(before, "struct")) {
      found_.names[token.text] = {DeclaredKind::Struct, {}, token.line};
      return;
    }
    const bool can_follow = before.kind == GlslTokenKind::Word || is_any_sign(before, ",]}");
    if (!can_follow || !is_any_sign(behind, "(;=,[")) return;
    const DeclaredKind kind = is_sign(behind, '(') ? DeclaredKind::Function : DeclaredKind::Variable;
    if (before.kind == GlslTokenKind::Word && !before.in_directive) type_ = before.text;
    found_.names.try_emplace(token.text, Declaration{kind, type_, token.line});
  }

  struct Conditional {
    int before = 0;  // how deep it stands
    std::optional<int> behind;
  };

  const CodeTokens& tokens_;
  Declarations found_;
  std::vector<Conditional> conditionals_;
  std::string_view type_;  // of the declaration that stands here
  std::size_t at_ = 0;
  int depth_ = 0;
  int struct_depth_ = 0;  // 0 outside of structs
};

}  // namespace

bool is_word(const GlslToken& token, std::string_view text) {
  return token.kind == GlslTokenKind::Word && token.text == text;
}

bool is_sign(const GlslToken& token, char sign) {
  return token.kind == GlslTokenKind::Sign && token.text.front() == sign;
}

bool is_any_sign(const GlslToken& token, std::string_view signs) {
  return token.kind == GlslTokenKind::Sign && signs.find(token.text.front()) != std::string_view::npos;
}

CodeTokens::CodeTokens(std::string_view code) : all(lex_glsl(code)) {
  std::ranges::copy_if(all, std::back_inserter(solid),
                       [](const GlslToken& token) { return token.kind != GlslTokenKind::Blank; });
}

Declarations find_declarations(const CodeTokens& tokens) {
  return DeclarationFinder(tokens).run();
}

}  // namespace texbrdf::scene

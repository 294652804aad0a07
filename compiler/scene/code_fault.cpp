// Faults of users' code that a lexer can find.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/glsl_declarations.h"
#include "scene/user_code.h"

namespace texbrdf::scene {
namespace {

using Fault = std::optional<CodeFault>;

constexpr std::array<std::string_view, 8> kDirectives = {"define", "undef", "if",   "ifdef",
                                                         "ifndef", "else",  "elif", "endif"};
constexpr std::array<std::string_view, 8> kForbidden = {"discard", "uniform", "attribute", "varying",
                                                        "layout",  "buffer",  "shared",    "subroutine"};
constexpr std::array<std::string_view, 3> kInterfaces = {"in", "out", "inout"};
constexpr std::array<std::string_view, 2> kOwnTypes = {"FragmentProperties", "Primitive3D"};
constexpr std::array<std::string_view, 3> kOwnPrefixes = {"gl_", "scene_", "trace_"};
constexpr std::string_view kSigns = "()[]{}.,;:?+-*/%<>=!&|^~#";

template <typename Words>
bool is_one_of(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

Fault fault(const GlslToken& token, std::string message) {
  return CodeFault{token.line, std::move(message)};
}

/// Finds what would reach beyond the code: open brackets, comments and conditionals, and directives.
class StructureCheck {
 public:
  explicit StructureCheck(const CodeTokens& tokens) : tokens_(tokens) {}

  Fault run() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      if (Fault found = step(tokens_[at_])) return found;
    }
    if (!conditionals_.empty()) return fault(conditionals_.back(), "this conditional has no #endif");
    if (!open_.empty()) return fault(open_.back(), fmt::format("this `{}` is not closed", open_.back().text));
    if (!is_finished()) return fault(last_, "the code ends within a declaration: a `;` is missing");
    return std::nullopt;
  }

 private:
  Fault step(const GlslToken& token) {
    if (token.kind == GlslTokenKind::Unclosed) return fault(token, "this comment is not closed");
    if (token.kind == GlslTokenKind::Sign && kSigns.find(token.text.front()) == std::string_view::npos)
      return fault(token, "here is a character that GLSL does not have");
    if (token.in_directive) return is_first_of_directive() ? directive(tokens_[at_ + 1]) : std::nullopt;
    if (branches_left_ > 0) return std::nullopt;
    last_ = token;
    return bracket(token);
  }

  bool is_first_of_directive() const {
    return is_sign(tokens_[at_], '#') &&
           (at_ == 0 || !tokens_[at_ - 1].in_directive || tokens_[at_ - 1].line != tokens_[at_].line);
  }

  Fault directive(const GlslToken& word) {
    if (!word.in_directive || word.line != tokens_[at_].line) return std::nullopt;
    if (!is_one_of(kDirectives, word.text)) {
      return fault(word,
                   fmt::format("`#{}` is not allowed here: there are #define, #undef and conditionals", word.text));
    }
    const bool opens = word.text.starts_with("if");
    if (opens) conditionals_.push_back(word);
    if (opens && branches_left_ > 0) ++branches_left_;
    if (!opens && word.text.starts_with('e')) return end_branch(word);
    return std::nullopt;
  }

  /// Brackets of other branches than the first are not counted.
  Fault end_branch(const GlslToken& word) {
    if (conditionals_.empty()) return fault(word, fmt::format("`#{}` without a conditional", word.text));
    if (word.text == "endif") {
      conditionals_.pop_back();
      if (branches_left_ > 0) --branches_left_;
    } else if (branches_left_ == 0) {
      branches_left_ = 1;
    }
    return std::nullopt;
  }

  Fault bracket(const GlslToken& token) {
    constexpr std::string_view kOpen = "({[";
    constexpr std::string_view kClose = ")}]";
    if (is_word(token, "struct") && open_.empty()) in_struct_ = true;
    if (is_any_sign(token, ";(") && open_.empty()) in_struct_ = false;
    if (is_any_sign(token, kOpen)) open_.push_back(token);
    if (!is_any_sign(token, kClose)) return std::nullopt;
    const char open = kOpen[kClose.find(token.text.front())];
    if (open_.empty()) return fault(token, fmt::format("this `{}` closes nothing", token.text));
    if (!is_sign(open_.back(), open))
      return fault(open_.back(), fmt::format("this `{}` is not closed before a `{}`", open_.back().text, token.text));
    open_.pop_back();
    return std::nullopt;
  }

  bool is_finished() const { return last_.text.empty() || is_sign(last_, ';') || (is_sign(last_, '}') && !in_struct_); }

  const CodeTokens& tokens_;
  std::size_t at_ = 0;
  std::vector<GlslToken> open_;
  std::vector<GlslToken> conditionals_;
  int branches_left_ = 0;   // conditionals inside a branch that is not counted, with its own
  bool in_struct_ = false;  // in the declaration of a struct, to its `;`
  GlslToken last_;
};

bool is_of_renderer(std::string_view word) {
  return std::ranges::any_of(kOwnPrefixes, [&](std::string_view prefix) { return word.starts_with(prefix); });
}

Fault word_fault(const CodeTokens& tokens, const Declarations& declared) {
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const GlslToken& token = tokens[i];
    if (!token.in_directive && is_any_sign(token, "({[")) ++depth;
    if (!token.in_directive && is_any_sign(token, ")}]")) --depth;
    if (token.kind != GlslTokenKind::Word) continue;
    const bool is_global_interface = depth == 0 && !token.in_directive && is_one_of(kInterfaces, token.text);
    if (is_one_of(kForbidden, token.text) || is_global_interface)
      return fault(token, fmt::format("`{}` is not allowed in code of a scene", token.text));
    if (is_of_renderer(token.text) && (!declared.has(token.text) || token.text.starts_with("gl_")))
      return fault(token, fmt::format("`{}` is a name of the renderer", token.text));
  }
  return std::nullopt;
}

/// What every code has to keep.
Fault common_fault(const CodeTokens& tokens, const Declarations& declared) {
  if (Fault found = StructureCheck(tokens).run()) return found;
  if (Fault found = word_fault(tokens, declared)) return found;
  for (const std::string_view type : kOwnTypes) {
    const auto found = declared.names.find(type);
    if (found != declared.names.end())
      return CodeFault{found->second.line, fmt::format("`{}` is declared already", type)};
  }
  return std::nullopt;
}

Fault function_fault(const Declarations& declared, std::string_view name, std::string_view type,
                     std::string_view signature) {
  const auto found = declared.names.find(name);
  if (found == declared.names.end() || found->second.kind != DeclaredKind::Function)
    return CodeFault{0, fmt::format("the code has no function `{}`", signature)};
  if (in_glsl(found->second.type) != type)
    return CodeFault{found->second.line, fmt::format("`{}` is not declared as `{}`", name, signature)};
  return std::nullopt;
}

Fault property_fault(const Declarations& declared, const Property& property) {
  const auto found = declared.names.find(property.name);
  const std::string_view type = property_type_name(property.type);
  if (found == declared.names.end() || found->second.kind != DeclaredKind::Variable)
    return CodeFault{0, fmt::format("the code has no global `{} {};` for the property", type, property.name)};
  if (in_glsl(found->second.type) != in_glsl(type))
    return CodeFault{found->second.line, fmt::format("the property `{}` is a {}, its global a {}", property.name, type,
                                                     found->second.type)};
  return std::nullopt;
}

}  // namespace

std::optional<CodeFault> find_code_fault(const UserPrimitive& primitive) {
  const CodeTokens tokens(primitive.code);
  const Declarations declared = find_declarations(tokens);
  if (Fault found = common_fault(tokens, declared)) return found;
  return function_fault(declared, primitive.name, "float",
                        fmt::format("float {}(vec3 p, Primitive3D primitive)", primitive.name));
}

std::optional<CodeFault> find_code_fault(const Shader& shader) {
  if (shader.kind == ShaderKind::Brdf) return std::nullopt;  // not written by a user
  const CodeTokens tokens(shader.code);
  const Declarations declared = find_declarations(tokens);
  if (Fault found = common_fault(tokens, declared)) return found;
  if (Fault found = function_fault(declared, "shade", "vec3", "float3 shade(FragmentProperties properties)"))
    return found;
  for (const Property& property : shader.properties) {
    if (Fault found = property_fault(declared, property)) return found;
  }
  return std::nullopt;
}

}  // namespace texbrdf::scene

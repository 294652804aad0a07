#pragma once

#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "scene/glsl_lexer.h"

namespace texbrdf::scene {

bool is_word(const GlslToken& token, std::string_view text);
bool is_sign(const GlslToken& token, char sign);
bool is_any_sign(const GlslToken& token, std::string_view signs);

/// Code as tokens, with and without blanks. The code outlives it.
struct CodeTokens {
  std::vector<GlslToken> all;
  std::vector<GlslToken> solid;  ///< those that are no blanks

  explicit CodeTokens(std::string_view code);
  /// A blank where there is none.
  const GlslToken& operator[](std::size_t i) const { return i < solid.size() ? solid[i] : none_; }
  std::size_t size() const { return solid.size(); }

 private:
  GlslToken none_;
};

enum class DeclaredKind : uint8_t { Function, Variable, Struct, Macro };

struct Declaration {
  DeclaredKind kind = DeclaredKind::Variable;
  std::string_view type;  ///< of functions and variables: the last word before the name
  uint32_t line = 0;
};

/// What code declares outside of functions.
struct Declarations {
  std::map<std::string_view, Declaration> names;
  std::set<std::size_t> fields;  ///< the tokens, by their index in CodeTokens::solid, that name a field of a struct

  bool has(std::string_view name) const { return names.contains(name); }
};

Declarations find_declarations(const CodeTokens& tokens);

}  // namespace texbrdf::scene

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace texbrdf::scene {

/// What is wrong with code, as far as it can be told without knowing types.
struct CodeFault {
  uint32_t line = 0;  ///< of the code, counted from 0
  std::string message;
};

/// Nothing where the code stands for itself: it has the function and the globals that are asked of it, its brackets and
/// conditionals are closed, and it has no directive and no word that would change what is around it. What is left is
/// for a GLSL compiler to find.
std::optional<CodeFault> find_code_fault(const UserPrimitive& primitive);
std::optional<CodeFault> find_code_fault(const Shader& shader);

/// The code with all names that it declares outside of functions (functions, globals, structs, macros) beginning with
/// `prefix`, and with the words of slang_words.def as GLSL. Lines stay lines. `uniform` is left out.
std::string with_prefix(std::string_view code, std::string_view prefix);

/// What stands for a word of slang_words.def; any other word is its own.
std::string_view in_glsl(std::string_view word);

/// Whether the word stands in the code, comments apart.
bool has_word(std::string_view code, std::string_view word);

}  // namespace texbrdf::scene

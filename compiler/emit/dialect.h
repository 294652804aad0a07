#pragma once

#include <span>
#include <string_view>

#include "emit/emit.h"

namespace texbrdf::emit {

/// Names that a target forbids; each list of words is separated by spaces.
struct ForbiddenNames {
  std::span<const std::string_view> words;
  std::span<const std::string_view> prefixes;
  std::span<const std::string_view> suffixes;
};

/// How a target wants its code: one table line each in dialect.cpp.
struct Dialect {
  std::string_view entry_point;
  bool zero_below_horizon;
  ForbiddenNames host;  ///< beside the language's own
};

extern const Dialect kGlslDialect;
extern const Dialect kExplorerDialect;

/// Whether a name must not be declared: a word of GLSL, of the target's host, of the signature of the entry point
/// (L, V, N, X, Y), of an emitted helper, or of a reserved family (gl_…, a double underscore).
bool is_forbidden(const Dialect& dialect, std::string_view name);

}  // namespace texbrdf::emit

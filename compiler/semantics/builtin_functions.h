#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "semantics/types.h"

namespace texbrdf {

/// The functions that need no definition, from builtin_functions.def. A definition of the document wins.
enum class Builtin : uint8_t {
#define BUILTIN(name, spellings, parameters, result, meaning) name,
#include "semantics/builtin_functions.def"
#undef BUILTIN
};

/// The canonical form of `\chi^+`, which papers write for Builtin::UnitStep.
inline constexpr std::string_view kStepFunction = "\\chi_+";

struct BuiltinEntry {
  std::string_view spellings;  ///< separated by spaces
  Signature signature;
  std::string_view meaning;
};

std::span<const BuiltinEntry> builtin_functions();
const BuiltinEntry& builtin_entry(Builtin function);

/// Its signature where the arguments have these types: vectors of another length and matrices of another size are
/// parameters as the first such argument is.
Signature signature_for(Builtin function, std::span<const Type> arguments);

/// The function of a canonical name: `saturate`, `\\text{saturate}` or `\\saturate`.
std::optional<Builtin> find_builtin(std::string_view canonical);

}  // namespace texbrdf

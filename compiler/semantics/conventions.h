#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "semantics/types.h"

namespace texbrdf {

/// Built-in names, from conventions.def.
enum class Convention : uint8_t {
#define CONVENTION(name, type, spellings, operands, symbol, formula, meaning) name,
#include "semantics/conventions.def"
#undef CONVENTION
};

struct ConventionEntry {
  Convention id;
  Type type;
  std::vector<std::string_view> spellings;  ///< canonical forms; empty for what has usual names only
  std::vector<Convention> operands;
  std::string_view symbol;
  std::string_view formula;
  std::string_view meaning;
};

const ConventionEntry& convention_entry(Convention id);
std::span<const ConventionEntry> conventions();
/// It is one of the others, or its value is made of one of them.
bool depends_on(Convention convention, std::span<const Convention> others);
/// By the canonical form of a name.
std::optional<Convention> find_convention(std::string_view canonical);

/// A name that papers use without defining it, from usual_names.def.
struct UsualName {
  std::string_view spelling;  ///< canonical form
  Convention meaning;
};

/// By spelling, in order.
std::span<const UsualName> usual_names();
std::optional<Convention> find_usual_name(std::string_view canonical);

inline constexpr double kPi = 3.141592653589793;
inline constexpr double kEpsilon = 1.192092896e-07;
inline constexpr double kEuler = 2.718281828459045;
/// The value of Pi and Epsilon; no other convention is constant.
std::optional<double> convention_constant(Convention id);

}  // namespace texbrdf

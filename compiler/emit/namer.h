#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "emit/dialect.h"
#include "semantics/names.h"

namespace texbrdf::emit {

/// The identifier a reader expects: `\rho_d` is rho_d, `\text{cook\_torrance}` cook_torrance, `\vec{H}` H, `f_{n_i}`
/// f_n_i, `x_{n+1}` x_n_plus_1. Legal in C-like languages, at most kLongestIdentifier characters, never empty; but
/// maybe a reserved word.
std::string identifier(const Name& name);
inline constexpr std::size_t kLongestIdentifier = 32;

/// The names of one scope of generated code: each claimed once, none forbidden by the dialect. The same claims in the
/// same order give the same names.
class Namer {
 public:
  explicit Namer(const Dialect& dialect) : dialect_(&dialect) {}

  /// Takes a name as it is: one that the dialect itself gives (`L`).
  void reserve(std::string_view name) { taken_.emplace(name); }
  bool taken(std::string_view name) const { return taken_.contains(name); }
  /// `wanted`, or the nearest to it that is free: `sin_`, `H_vec`, `H_2`.
  std::string claim(const Name& wanted);
  std::string claim(std::string_view wanted);

 private:
  bool free(std::string_view name) const;
  std::string numbered(const std::string& stem);

  const Dialect* dialect_;
  std::set<std::string, std::less<>> taken_;
  std::map<std::string, uint32_t, std::less<>> last_number_;
};

}  // namespace texbrdf::emit

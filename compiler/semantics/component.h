#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf {

/// `h_x`, `\omega_{o_z}`, `\vec{v_z}`: a vector's component along an axis of the tangent frame, by its name; and
/// `\mu_0` and `\mu`, what \omega_i and \omega_o have along the normal. The fourth of ℝ⁴ is `s_w`.
struct ComponentName {
  std::vector<std::string> vectors;  ///< what the vector may be called, by canonical forms: `h`, `\vec{h}`
  uint32_t axis = 0;                 ///< 0 tangent, 1 bitangent, 2 normal, 3 of ℝ⁴ only
};

std::optional<ComponentName> component_name(std::string_view canonical);

/// An entry of a matrix, `M_{12}` or `M_{1,2}`, or of ℝ² and ℝ⁴, `m_x` or `m_1`, by its name.
struct EntryName {
  std::vector<std::string> aggregates;  ///< what the matrix or vector may be called
  uint32_t row = 0;                     ///< from 0
  std::optional<uint32_t> column;       ///< of a matrix
};

std::optional<EntryName> entry_name(std::string_view canonical);

/// "x" of `x_+`, which is what is positive of x; empty for other names.
constexpr std::string_view name_of_positive_part(std::string_view canonical) {
  constexpr std::string_view kSign = "_+";
  return canonical.ends_with(kSign) ? canonical.substr(0, canonical.size() - kSign.size()) : std::string_view();
}

}  // namespace texbrdf

#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <utility>

namespace texbrdf::scene {

/// Numbers as GLSL, in single precision; what is larger than that holds is the largest.
std::string float_text(double number);
std::string vector_text(const glm::dvec3& vector);
std::string matrix_text(const glm::dmat3& matrix);

/// Statements for the value of an int variable: the text of the last case whose number is not above it. At least one
/// case, in rising order; a tree of conditions as high as the logarithm of their number.
std::string choice_text(std::string_view variable, std::span<const std::pair<uint32_t, std::string>> cases);

}  // namespace texbrdf::scene

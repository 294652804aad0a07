#pragma once

#include "syntax/parsed_block.h"

namespace texbrdf {

/// What an exponent says where the base is a matrix or a vector.
enum class MatrixPower : uint8_t {
  None,               ///< a power of numbers
  Transposed,         ///< `M^T`, `M^\top`, `M^{\mathsf T}`, `M^\intercal`
  Inverse,            ///< `M^{-1}`
  InverseTransposed,  ///< `M^{-T}`
};

/// Of any node; None where it is no power.
MatrixPower matrix_power(const ParsedBlock& block, NodeId node);
/// The name is the sign of such an exponent, and need not be one of the document.
bool is_transposition_sign(const ParsedBlock& block, NodeId name);

}  // namespace texbrdf

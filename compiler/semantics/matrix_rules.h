#pragma once

#include <optional>

#include "semantics/operator_rules.h"

namespace texbrdf {

// What linear algebra makes of types by their shapes; a vector is a column. Nothing where it makes nothing.

/// Of operands of which one or both are aggregates; Error where the other is unknown and so is the result. A vector
/// before a matrix that it cannot be multiplied with as a column is a row. With an operator between them two vectors of
/// one length have a dot product, side by side a row and a column.
std::optional<Type> matrix_result(Operator op, Type left, Type right);

/// Of `(a, b)`: ℝ², the type of a triple, or ℝ⁴.
std::optional<Type> tuple_type(size_t components);
/// Of a matrix, a row or a vector. A tuple is one, and a colour is none.
std::optional<Type> transposed(Type type);
/// Whether a value of the type has a determinant, a trace and an inverse.
bool is_square_matrix(Type type);
/// ℝ², ℝ³ and ℝ⁴, of which a tuple may be one.
bool is_column(Type type);

}  // namespace texbrdf

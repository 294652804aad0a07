#pragma once

#include <functional>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::ir {

/// Values of a graph in rows and columns, all real.
struct MatrixValue {
  Shape shape;
  std::vector<ValueId> entries;  ///< row by row

  ValueId at(uint32_t row, uint32_t column) const { return entries[row * shape.columns + column]; }
};

// Linear algebra written out in operations on reals. Shapes are those that matrix_rules.h demands.

MatrixValue transpose(const MatrixValue& matrix);
MatrixValue product(Graph& graph, const MatrixValue& left, const MatrixValue& right);
/// The sum of the products of entries at one place: of two vectors the dot product, whether rows or columns.
ValueId dot(Graph& graph, const MatrixValue& left, const MatrixValue& right);
/// By the first row.
ValueId determinant(Graph& graph, const MatrixValue& matrix);
ValueId trace(Graph& graph, const MatrixValue& matrix);
/// The cofactors, transposed, over the determinant: infinite or not a number where that is 0.
MatrixValue inverse(Graph& graph, const MatrixValue& matrix);
MatrixValue map_entries(const MatrixValue& matrix, const std::function<ValueId(ValueId)>& function);
/// Of two matrices of one shape.
MatrixValue map_pairs(const MatrixValue& left, const MatrixValue& right,
                      const std::function<ValueId(ValueId, ValueId)>& function);

}  // namespace texbrdf::ir

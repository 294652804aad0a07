#include "ir/matrix_algebra.h"

#include "source/internal_error.h"

namespace texbrdf::ir {
namespace {

/// Without a row and a column.
MatrixValue minor(const MatrixValue& matrix, uint32_t row, uint32_t column) {
  MatrixValue rest{{matrix.shape.rows - 1, matrix.shape.columns - 1}, {}};
  for (uint32_t r = 0; r < matrix.shape.rows; ++r) {
    for (uint32_t c = 0; c < matrix.shape.columns; ++c) {
      if (r != row && c != column) rest.entries.push_back(matrix.at(r, c));
    }
  }
  return rest;
}

ValueId sum(Graph& graph, const std::vector<ValueId>& terms) {
  ValueId total = terms.front();
  for (size_t i = 1; i < terms.size(); ++i) total = graph.add(Op::Add, {total, terms[i]});
  return total;
}

ValueId cofactor(Graph& graph, const MatrixValue& matrix, uint32_t row, uint32_t column) {
  const ValueId value = determinant(graph, minor(matrix, row, column));
  return (row + column) % 2 == 1 ? graph.add(Op::Negate, {value}) : value;
}

}  // namespace

MatrixValue transpose(const MatrixValue& matrix) {
  MatrixValue result{{matrix.shape.columns, matrix.shape.rows}, {}};
  for (uint32_t row = 0; row < result.shape.rows; ++row) {
    for (uint32_t column = 0; column < result.shape.columns; ++column) {
      result.entries.push_back(matrix.at(column, row));
    }
  }
  return result;
}

MatrixValue product(Graph& graph, const MatrixValue& left, const MatrixValue& right) {
  require(left.shape.columns == right.shape.rows, "a product of matrices that do not fit");
  MatrixValue result{{left.shape.rows, right.shape.columns}, {}};
  for (uint32_t row = 0; row < result.shape.rows; ++row) {
    for (uint32_t column = 0; column < result.shape.columns; ++column) {
      std::vector<ValueId> terms;
      for (uint32_t i = 0; i < right.shape.rows; ++i) {
        terms.push_back(graph.add(Op::Multiply, {left.at(row, i), right.at(i, column)}));
      }
      result.entries.push_back(sum(graph, terms));
    }
  }
  return result;
}

ValueId dot(Graph& graph, const MatrixValue& left, const MatrixValue& right) {
  require(left.entries.size() == right.entries.size(), "a dot product of vectors of different length");
  std::vector<ValueId> terms;
  for (size_t i = 0; i < left.entries.size(); ++i) {
    terms.push_back(graph.add(Op::Multiply, {left.entries[i], right.entries[i]}));
  }
  return sum(graph, terms);
}

ValueId determinant(Graph& graph, const MatrixValue& matrix) {
  require(matrix.shape.is_square(), "a determinant of what is not square");
  if (matrix.shape.rows == 1) return matrix.entries[0];
  ValueId total;
  for (uint32_t column = 0; column < matrix.shape.columns; ++column) {
    const ValueId rest = determinant(graph, minor(matrix, 0, column));
    const ValueId term = graph.add(Op::Multiply, {matrix.at(0, column), rest});
    if (column == 0) total = term;
    if (column != 0) total = graph.add(column % 2 == 1 ? Op::Subtract : Op::Add, {total, term});
  }
  return total;
}

ValueId trace(Graph& graph, const MatrixValue& matrix) {
  std::vector<ValueId> terms;
  for (uint32_t i = 0; i < matrix.shape.rows; ++i) terms.push_back(matrix.at(i, i));
  return sum(graph, terms);
}

MatrixValue inverse(Graph& graph, const MatrixValue& matrix) {
  const ValueId whole = determinant(graph, matrix);
  MatrixValue result{matrix.shape, {}};
  for (uint32_t row = 0; row < matrix.shape.rows; ++row) {
    for (uint32_t column = 0; column < matrix.shape.columns; ++column) {
      const ValueId part = cofactor(graph, matrix, column, row);
      result.entries.push_back(graph.add(Op::Divide, {part, whole}));
    }
  }
  return result;
}

MatrixValue map_entries(const MatrixValue& matrix, const std::function<ValueId(ValueId)>& function) {
  MatrixValue result{matrix.shape, {}};
  for (const ValueId entry : matrix.entries) result.entries.push_back(function(entry));
  return result;
}

MatrixValue map_pairs(const MatrixValue& left, const MatrixValue& right,
                      const std::function<ValueId(ValueId, ValueId)>& function) {
  require(left.shape == right.shape, "entries of matrices of different shape");
  MatrixValue result{left.shape, {}};
  for (size_t i = 0; i < left.entries.size(); ++i) {
    result.entries.push_back(function(left.entries[i], right.entries[i]));
  }
  return result;
}

}  // namespace texbrdf::ir

#include <algorithm>
#include <string>
#include <utility>

#include "syntax/math_regions.h"
#include "syntax/parser.h"

namespace texbrdf {
namespace {

/// And columns.
constexpr size_t kMostRows = 4;

std::string count_of_entries(size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

}  // namespace

/// `\begin{pmatrix} a & b \\ c & d \end{pmatrix}`. A row or a column is a tuple, the bars of vmatrix are bars.
Parser::Part Parser::parse_matrix() {
  ++open_rows_;
  const uint32_t opener = advance();
  const bool in_condition = std::exchange(in_condition_, false);
  const size_t first_cell = list_.size();
  std::vector<size_t> row_lengths = parse_matrix_cells();
  in_condition_ = in_condition;
  if (list_.size() == first_cell) {
    report_expected(Code::NoExpression);
    list_.push_back(error_here());
  }
  const bool closed = close_environment(opener);
  const std::span<const Part> cells = std::span(list_).subspan(first_cell);
  Part matrix = closed ? make_matrix(opener, cells, row_lengths)
                       : make(NodeKind::Error, opener, opener, cells.data(), cells.size());
  list_.resize(first_cell);
  if (!matrix.damaged && environment_name(block_.token_text(opener)) == "vmatrix") {
    matrix = make(NodeKind::Bars, opener, opener, {matrix});
  }
  return matrix;
}

/// Puts them on `list_`; how many each row has.
std::vector<size_t> Parser::parse_matrix_cells() {
  std::vector<size_t> row_lengths = {0};
  while (!at(TokenKind::CloseMatrix)) {
    list_.push_back(parse_inside());
    ++row_lengths.back();
    if (at(TokenKind::RowEnd) && kind_behind(position_) != TokenKind::CloseMatrix) {
      row_lengths.push_back(0);
    } else if (!at(TokenKind::RowEnd) && !at(TokenKind::CellEnd) && !at(TokenKind::Comma)) {
      break;
    }
    advance();
    recovering_ = false;
  }
  return row_lengths;
}

Parser::Part Parser::make_matrix(uint32_t opener, std::span<const Part> cells, std::span<const size_t> row_lengths) {
  const size_t columns = *std::ranges::max_element(row_lengths);
  if (row_lengths.size() == 1 || columns == 1) {
    return make(NodeKind::Tuple, opener, opener, cells.data(), cells.size());
  }
  const bool is_too_large = row_lengths.size() > kMostRows || columns > kMostRows;
  const bool is_damaged = std::ranges::any_of(cells, &Part::damaged);
  if (is_too_large && !is_damaged) {
    report(Code::MatrixTooLarge, opener, {std::to_string(row_lengths.size()), std::to_string(columns)});
  }
  std::vector<Part> rows;
  for (size_t i = 0; i < row_lengths.size() && !is_too_large && !is_damaged; ++i) {
    const std::span<const Part> row = cells.first(row_lengths[i]);
    cells = cells.subspan(row_lengths[i]);
    rows.push_back(make_matrix_row(row));
    if (row_lengths[i] == row_lengths[0]) continue;
    report(Code::RaggedMatrix, first_token(rows.back()), block_.span(rows.back().node),
           {count_of_entries(row_lengths[i]), std::to_string(row_lengths[0])});
  }
  recovering_ = false;
  if (is_too_large || is_damaged) return make(NodeKind::Error, opener, opener, cells.data(), cells.size());
  const bool is_even = std::ranges::all_of(row_lengths, [&](size_t length) { return length == row_lengths[0]; });
  return make(is_even ? NodeKind::Matrix : NodeKind::Error, opener, opener, rows.data(), rows.size());
}

/// It ended before what the parser reads now.
Parser::Part Parser::make_matrix_row(std::span<const Part> cells) {
  std::vector<NodeId> entries;
  Part row;
  for (const Part& cell : cells) {
    entries.push_back(cell.node);
    row.height = std::max(row.height, cell.height + 1);
  }
  const uint32_t first = first_token(cells.front());
  const uint32_t end = block_.tree.node(entries.back()).end_token;
  row.node = block_.tree.add(NodeKind::MatrixRow, first, first, end, entries);
  return row;
}

}  // namespace texbrdf

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "eval/evaluate.h"
#include "source/result.h"

namespace texbrdf::cli {

/// Directions of a CSV file, one geometry a line.
struct DirectionTable {
  bool has_frame = false;  ///< the nine columns of N, X, Y are there
  std::vector<eval::Geometry> rows;
};

/// Reads columns Lx,Ly,Lz,Vx,Vy,Vz and, all or none, Nx,Ny,Nz,Xx,Xy,Xz,Yx,Yy,Yz, in any order; others are ignored.
/// A fault names the line, counted from 1.
Result<DirectionTable> read_directions(std::string_view csv);

/// The same columns, then r,g,b; the shortest digits that read back as the same number.
std::string write_values(const DirectionTable& table, const std::vector<std::array<double, 3>>& values);
std::string write_values(const DirectionTable& table, const std::vector<std::array<float, 3>>& values);

}  // namespace texbrdf::cli

#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "eval/compile.h"
#include "support/evaluation.h"
#include "support/random.h"

namespace texbrdf::test {

/// A row of a model's table of published values.
struct ReferenceRow {
  eval::Geometry geometry;
  eval::Triple value;
};

inline const std::vector<std::string>& model_names() {
  static const std::vector<std::string> names = {"ashikhmin-shirley-alternative",
                                                 "ashikhmin-shirley",
                                                 "blinn-phong",
                                                 "conventions",
                                                 "cook-torrance-alternative",
                                                 "cook-torrance",
                                                 "duer",
                                                 "edwards-2006",
                                                 "kajiya-kay",
                                                 "minnaert",
                                                 "oren-nayar",
                                                 "ward"};
  return names;
}

inline std::string model_path(const std::string& name, const std::string& extension) {
  return std::string(TEXBRDF_TEST_DATA) + "/models/" + name + extension;
}

inline std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Columns Lx,Ly,Lz,Vx,Vy,Vz,r,g,b behind one line of names; the frame is the standard one.
inline std::vector<ReferenceRow> read_rows(const std::string& path) {
  std::ifstream file(path);
  std::vector<ReferenceRow> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::array<double, 9> numbers{};
    std::string field;
    for (double& number : numbers) {
      std::getline(fields, field, ',');
      number = std::stod(field);
    }
    rows.push_back(
        {.geometry = {.light = {numbers[0], numbers[1], numbers[2]}, .view = {numbers[3], numbers[4], numbers[5]}},
         .value = {numbers[6], numbers[7], numbers[8]}});
  }
  return rows;
}

inline std::vector<ReferenceRow> read_reference(const std::string& model) {
  return read_rows(model_path(model, ".csv"));
}

inline Result<eval::CompiledModel> compile_text(const std::string& text) {
  Document document(text);
  const Result<ir::Program> program = document.snapshot().program();
  if (!program) return Failure{program.error()};
  return eval::compile(*program);
}

/// A rotation, as a map of vectors.
class Rotation {
 public:
  /// By a unit quaternion of random direction.
  explicit Rotation(Random& random) {
    std::array<double, 4> q{};
    double length = 0;
    while (length < 0.1) {
      length = 0;
      for (double& x : q) {
        x = random.real(-1, 1);
        length += x * x;
      }
    }
    for (double& x : q) x /= std::sqrt(length);
    const auto [w, x, y, z] = q;
    rows_ = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
              {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
              {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
  }

  eval::Triple operator()(const eval::Triple& v) const {
    eval::Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = rows_[i][0] * v[0] + rows_[i][1] * v[1] + rows_[i][2] * v[2];
    return result;
  }
  eval::Geometry operator()(const eval::Geometry& g) const {
    return {.light = (*this)(g.light),
            .view = (*this)(g.view),
            .normal = (*this)(g.normal),
            .tangent = (*this)(g.tangent),
            .bitangent = (*this)(g.bitangent)};
  }

 private:
  std::array<eval::Triple, 3> rows_{};
};

/// A direction whose polar angle in the standard frame is below `cosine`'s arc.
inline eval::Triple random_direction(Random& random, double least_cosine) {
  const double z = random.real(least_cosine, 1);
  const double azimuth = random.real(-3.141592653589793, 3.141592653589793);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

/// What a batch sees: the same geometry in single precision.
inline eval::Geometry in_single_precision(eval::Geometry g) {
  for (auto* vector : {&g.light, &g.view, &g.normal, &g.tangent, &g.bitangent}) {
    for (double& x : *vector) x = static_cast<float>(x);
  }
  return g;
}

/// The largest deviation seen, and where more was seen than allowed.
class Deviation {
 public:
  Deviation(double relative, double absolute) : relative_(relative), absolute_(absolute) {}

  void compare(const eval::Triple& actual, const eval::Triple& expected, const std::string& where) {
    for (std::size_t i = 0; i < 3; ++i) compare(actual[i], expected[i], where);
  }
  /// Of the deviation that is allowed: above 1 the comparison fails.
  double share() const { return share_; }
  /// |Δ| / |expected|, of the values above the absolute tolerance.
  double largest_relative() const { return largest_relative_; }
  const std::string& first_failure() const { return first_failure_; }

 private:
  void compare(double actual, double expected, const std::string& where) {
    if (std::isnan(actual) && std::isnan(expected)) return;
    if (actual == expected) return;
    const double difference = std::abs(actual - expected);
    const double share = difference / (relative_ * std::abs(expected) + absolute_);
    // Not `share > 1`: NaN on one side fails too.
    if (!(share <= 1) && first_failure_.empty()) {
      std::ostringstream text;
      text.precision(17);
      text << where << ": " << actual << " instead of " << expected;
      first_failure_ = text.str();
    }
    if (!(share <= share_)) share_ = share;
    if (std::abs(expected) > absolute_) {
      largest_relative_ = std::max(largest_relative_, difference / std::abs(expected));
    }
  }

  double relative_;
  double absolute_;
  double share_ = 0;
  double largest_relative_ = 0;
  std::string first_failure_;
};

}  // namespace texbrdf::test

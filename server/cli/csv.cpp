#include "cli/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

#include "source/trimmed.h"

namespace texbrdf::cli {
namespace {

constexpr std::array<std::string_view, 15> kColumns = {"Lx", "Ly", "Lz", "Vx", "Vy", "Vz", "Nx", "Ny",
                                                       "Nz", "Xx", "Xy", "Xz", "Yx", "Yy", "Yz"};
constexpr std::size_t kDirectionColumns = 6;

std::size_t column_count(const DirectionTable& table) {
  return table.has_frame ? kColumns.size() : kDirectionColumns;
}

/// The numbers of a geometry in the order of kColumns.
std::array<double*, 15> numbers_of(eval::Geometry& geometry) {
  std::array<double*, 15> numbers{};
  std::size_t next = 0;
  for (auto* vector : {&geometry.light, &geometry.view, &geometry.normal, &geometry.tangent, &geometry.bitangent}) {
    for (double& number : *vector) numbers[next++] = &number;
  }
  return numbers;
}

/// Lines without their ends ("\n" or "\r\n"), counted.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  std::size_t number() const { return number_; }

  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    ++number_;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

std::string_view content_of(std::string_view cell) {
  cell = trimmed(cell, " \t");
  if (cell.size() >= 2 && cell.starts_with('"') && cell.ends_with('"')) cell = cell.substr(1, cell.size() - 2);
  return cell;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(content_of(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> read_number(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// Where each of kColumns stands in the header, or npos.
using Places = std::array<std::size_t, kColumns.size()>;
constexpr std::size_t kAbsent = SIZE_MAX;

Result<Places> read_header(std::string_view line) {
  const std::vector<std::string_view> names = split(line);
  Places places{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), kColumns[i]);
    places[i] = found == names.end() ? kAbsent : static_cast<std::size_t>(found - names.begin());
    if (found != names.end() && std::find(found + 1, names.end(), kColumns[i]) != names.end()) {
      return Failure{fmt::format("line 1: column {} appears twice", kColumns[i])};
    }
  }
  for (std::size_t i = 0; i < kDirectionColumns; ++i) {
    if (places[i] == kAbsent) return Failure{fmt::format("line 1: column {} is missing", kColumns[i])};
  }
  const auto frame = std::span(places).subspan(kDirectionColumns);
  const auto absent = std::count(frame.begin(), frame.end(), kAbsent);
  if (absent != 0 && absent != std::ssize(frame)) {
    const auto first = std::find(frame.begin(), frame.end(), kAbsent) - frame.begin();
    return Failure{fmt::format("line 1: column {} is missing (a frame needs all of Nx to Yz)",
                               kColumns[kDirectionColumns + static_cast<std::size_t>(first)])};
  }
  return places;
}

template <typename Number>
void append(fmt::memory_buffer& out, Number number, char after) {
  // A NaN's sign says nothing, and differs between machines.
  if (std::isnan(number)) {
    fmt::format_to(std::back_inserter(out), "nan{}", after);
  } else {
    fmt::format_to(std::back_inserter(out), "{}{}", number, after);
  }
}

template <typename Number>
std::string write_table(const DirectionTable& table, const std::vector<std::array<Number, 3>>& values) {
  const std::size_t columns = column_count(table);
  fmt::memory_buffer out;
  for (std::size_t i = 0; i < columns; ++i) fmt::format_to(std::back_inserter(out), "{},", kColumns[i]);
  fmt::format_to(std::back_inserter(out), "r,g,b\n");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    eval::Geometry geometry = table.rows[row];
    const auto numbers = numbers_of(geometry);
    for (std::size_t i = 0; i < columns; ++i) append(out, *numbers[i], ',');
    const auto& value = values[row];
    append(out, value[0], ',');
    append(out, value[1], ',');
    append(out, value[2], '\n');
  }
  return fmt::to_string(out);
}

}  // namespace

Result<DirectionTable> read_directions(std::string_view csv) {
  if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);
  Lines lines(csv);
  const auto header = lines.next();
  if (!header) return Failure{"line 1: the header is missing"};
  const Result<Places> places = read_header(*header);
  if (!places) return Failure{places.error()};

  DirectionTable table;
  table.has_frame = places->back() != kAbsent;
  while (const auto line = lines.next()) {
    if (content_of(*line).empty()) continue;
    const std::vector<std::string_view> cells = split(*line);
    eval::Geometry geometry;
    const auto numbers = numbers_of(geometry);
    for (std::size_t i = 0; i < column_count(table); ++i) {
      const std::size_t place = (*places)[i];
      if (place >= cells.size()) {
        return Failure{fmt::format("line {}: column {} is missing", lines.number(), kColumns[i])};
      }
      const std::optional<double> number = read_number(cells[place]);
      if (!number) {
        return Failure{
            fmt::format("line {}: column {} holds no finite number: '{}'", lines.number(), kColumns[i], cells[place])};
      }
      *numbers[i] = *number;
    }
    table.rows.push_back(geometry);
  }
  return table;
}

std::string write_values(const DirectionTable& table, const std::vector<std::array<double, 3>>& values) {
  return write_table(table, values);
}

std::string write_values(const DirectionTable& table, const std::vector<std::array<float, 3>>& values) {
  return write_table(table, values);
}

}  // namespace texbrdf::cli

#include "lighting/hdr_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <optional>
#include <span>
#include <string>

namespace texbrdf::lighting {

namespace {

using Fault = std::optional<std::string>;

struct Header {
  glm::dvec3 divisor{1};
  uint32_t width = 0;
  uint32_t height = 0;
  bool from_bottom = false;
  bool from_right = false;
};

/// As it is shown in a message: short, without bytes that a terminal obeys.
std::string shown(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 40)) shown += c >= ' ' && c < '\x7f' ? c : '?';
  return text.size() > 40 ? shown + "..." : shown;
}

/// Takes a line of the header, without its end; nothing where there is no whole one.
std::optional<std::string_view> take_line(std::string_view& bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view take_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// Numbers above 0 of a variable of the header, as many as asked for.
template <std::size_t count>
std::optional<std::array<double, count>> factors_of(std::string_view text) {
  std::array<double, count> factors{};
  for (double& factor : factors) {
    const std::string_view word = take_word(text);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), factor);
    if (error != std::errc{} || end != word.data() + word.size() || !(factor > 0 && std::isfinite(factor))) {
      return std::nullopt;
    }
  }
  return take_word(text).empty() ? std::optional(factors) : std::nullopt;
}

Fault read_variable(std::string_view line, Header& header) {
  if (line.starts_with("FORMAT=")) {
    std::string_view value = line.substr(7);
    const std::string_view format = take_word(value);
    if (format != "32-bit_rle_rgbe") return fmt::format("its format is '{}', not 32-bit_rle_rgbe", shown(format));
  } else if (line.starts_with("EXPOSURE=")) {
    const auto factor = factors_of<1>(line.substr(9));
    if (!factor) return fmt::format("'{}' is no exposure", shown(line));
    header.divisor *= (*factor)[0];
  } else if (line.starts_with("COLORCORR=")) {
    const auto factors = factors_of<3>(line.substr(10));
    if (!factors) return fmt::format("'{}' is no correction of colours", shown(line));
    header.divisor *= glm::dvec3((*factors)[0], (*factors)[1], (*factors)[2]);
  }
  return std::nullopt;
}

std::optional<uint32_t> count_of(std::string_view word) {
  uint32_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc{} || end != word.data() + word.size() || count == 0) return std::nullopt;
  return count;
}

Fault read_size(std::string_view line, Header& header) {
  std::string_view rest = line;
  const std::string_view rows = take_word(rest);
  const auto height = count_of(take_word(rest));
  const std::string_view columns = take_word(rest);
  const auto width = count_of(take_word(rest));
  if (!width || !height || !take_word(rest).empty()) return fmt::format("'{}' is no size", shown(line));
  if ((rows != "-Y" && rows != "+Y") || (columns != "-X" && columns != "+X")) {
    return fmt::format("its size '{}' does not give rows (Y) of columns (X)", shown(line));
  }
  if (uint64_t{*width} != uint64_t{*height} * 2) {
    return fmt::format("it is {} by {}; a picture of all directions is twice as wide as high", *width, *height);
  }
  if (uint64_t{*width} * *height > kMaxHdrTexels)
    return fmt::format("it is {} by {}, which is too large", *width, *height);
  header.width = *width;
  header.height = *height;
  header.from_bottom = rows == "+Y";
  header.from_right = columns == "-X";
  return std::nullopt;
}

/// Leaves the bytes behind the header.
Fault read_header(std::string_view& bytes, Header& header) {
  if (!bytes.starts_with("#?")) return "it is no Radiance picture: it does not begin with #?";
  while (true) {
    const auto line = take_line(bytes);
    if (!line) return "it ends in its header";
    if (line->empty()) break;
    if (auto wrong = read_variable(*line, header)) return wrong;
  }
  if (!glm::all(glm::greaterThan(header.divisor, glm::dvec3(1e-30))) ||
      !glm::all(glm::lessThan(header.divisor, glm::dvec3(1e30)))) {
    return "its exposures together are not between 1e-30 and 1e30";
  }
  const auto size = take_line(bytes);
  return size ? read_size(*size, header) : "it ends before its size";
}

struct Texel {
  std::array<uint8_t, 4> bytes{};  ///< three mantissas and an exponent
};

constexpr const char* kEndsEarly = "the file ends in it";
constexpr const char* kTooLong = "a run is longer than what is left of it";

/// Takes rows off the bytes behind the header.
class RowReader {
 public:
  explicit RowReader(std::string_view bytes) : bytes_(bytes) {}

  Fault read(std::span<Texel> row) {
    constexpr std::size_t kLeastNew = 8;
    constexpr std::size_t kMostNew = 0x7fff;
    if (bytes_.size() < 4) return kEndsEarly;
    const bool is_new = at(0) == 2 && at(1) == 2 && at(2) < 128 && row.size() >= kLeastNew && row.size() <= kMostNew;
    if (!is_new) return read_old(row);
    const std::size_t width = std::size_t{at(2)} << 8 | at(3);
    if (width != row.size()) return fmt::format("it is encoded for {} columns", width);
    bytes_.remove_prefix(4);
    for (std::size_t channel = 0; channel < 4; ++channel) {
      if (auto wrong = read_channel(row, channel)) return wrong;
    }
    return std::nullopt;
  }

 private:
  uint8_t at(std::size_t place) const { return static_cast<uint8_t>(bytes_[place]); }

  /// Above 128: the next byte so many times less 128; else so many bytes.
  Fault read_channel(std::span<Texel> row, std::size_t channel) {
    for (std::size_t column = 0; column < row.size();) {
      if (bytes_.size() < 2) return kEndsEarly;
      const bool is_run = at(0) > 128;
      const std::size_t count = is_run ? at(0) - 128U : at(0);
      if (count == 0) return "a run of nothing is in it";
      if (count > row.size() - column) return kTooLong;
      if (!is_run && bytes_.size() <= count) return kEndsEarly;
      for (std::size_t i = 0; i < count; ++i) row[column++].bytes[channel] = at(is_run ? 1 : 1 + i);
      bytes_.remove_prefix(is_run ? 2 : 1 + count);
    }
    return std::nullopt;
  }

  /// Plain texels; (1, 1, 1, n) repeats the one before n times, 256 n times if it follows another such, and so on.
  Fault read_old(std::span<Texel> row) {
    int shift = 0;
    for (std::size_t column = 0; column < row.size();) {
      if (bytes_.size() < 4) return kEndsEarly;
      const Texel texel{{at(0), at(1), at(2), at(3)}};
      bytes_.remove_prefix(4);
      const bool is_run = texel.bytes[0] == 1 && texel.bytes[1] == 1 && texel.bytes[2] == 1;
      if (!is_run) {
        row[column++] = texel;
        shift = 0;
        continue;
      }
      if (column == 0) return "it begins with a run";
      if (shift > 24) return kTooLong;
      const std::size_t count = std::size_t{texel.bytes[3]} << shift;
      if (count > row.size() - column) return kTooLong;
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(column), count, row[column - 1]);
      column += count;
      shift += 8;
    }
    return std::nullopt;
  }

  std::string_view bytes_;
};

glm::vec3 radiance_of(const Texel& texel, const glm::dvec3& divisor) {
  const auto& [red, green, blue, exponent] = texel.bytes;
  if (exponent == 0) return glm::vec3(0);
  return {glm::dvec3(red, green, blue) * std::ldexp(1.0, exponent - 136) / divisor};
}

void append(std::span<const Texel> row, const Header& header, std::vector<glm::vec3>& radiance) {
  for (const Texel& texel : row) radiance.push_back(radiance_of(texel, header.divisor));
}

/// As it was written: rows and columns in the order of the file.
Result<EnvironmentMap> read_rows(std::string_view bytes, const Header& header) {
  RowReader reader(bytes);
  EnvironmentMap map{header.width, header.height, {}};
  std::vector<Texel> row(header.width);
  for (uint32_t number = 1; number <= header.height; ++number) {
    if (const auto wrong = reader.read(row))
      return Failure{fmt::format("row {} of {}: {}", number, header.height, *wrong)};
    append(row, header, map.radiance);
  }
  return map;
}

void flip_rows(EnvironmentMap& map) {
  for (uint32_t row = 0; row < map.height / 2; ++row) {
    const auto first = map.radiance.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * map.width);
    const auto other = map.radiance.end() - static_cast<std::ptrdiff_t>(std::size_t{row + 1} * map.width);
    std::swap_ranges(first, first + map.width, other);
  }
}

void flip_columns(EnvironmentMap& map) {
  for (auto row = map.radiance.begin(); row != map.radiance.end(); row += map.width) std::reverse(row, row + map.width);
}

bool is_finite(const glm::vec3& colour) {
  return std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z);
}

}  // namespace

Result<EnvironmentMap> read_hdr(std::string_view bytes) {
  Header header;
  if (const auto wrong = read_header(bytes, header)) return Failure{*wrong};
  Result<EnvironmentMap> map = read_rows(bytes, header);
  if (!map) return map;
  if (!std::ranges::all_of(map->radiance, is_finite)) return Failure{"it has light that is too strong for a number"};
  const auto is_black = [](const glm::vec3& colour) { return colour == glm::vec3(0); };
  if (std::ranges::all_of(map->radiance, is_black)) return Failure{"it is black: there is no light in it"};
  if (header.from_bottom) flip_rows(*map);
  if (header.from_right) flip_columns(*map);
  return map;
}

}  // namespace texbrdf::lighting

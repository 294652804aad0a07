#include "objects/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "objects/obj_file.h"

namespace texbrdf::objects {

namespace {

constexpr std::string_view kBlanks = " \t";

/// Takes the first word off a line.
std::string_view take_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(kBlanks), line.size());
  const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// As it is shown in a message: short, without bytes that a terminal obeys.
std::string shown(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c < '\x7f' ? c : '?';
  return word.size() > 40 ? text + "..." : text;
}

/// The place of a thing in its list, as a face names it.
struct Reference {
  int64_t place;  ///< from 1 on
  std::size_t line;
};

class LineChecker {
 public:
  /// One line, or several that a backslash at their ends joins.
  std::optional<Failure> check(std::string_view joined, std::size_t number) {
    line_ = number;
    const std::string_view line = joined.substr(0, joined.find('#'));
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    const auto kind = std::ranges::find(kKeywords, keyword);
    if (kind == kKeywords.end()) return std::nullopt;
    const auto place = static_cast<std::size_t>(kind - kKeywords.begin());
    auto wrong = place < kKinds.size() ? check_numbers(rest, keyword, place) : check_face(rest);
    if (wrong) return wrong;
    if (place == kKinds.size()) kept_.face_lines.push_back(static_cast<uint32_t>(number));
    kept_.text.append(line).append("\n");
    return std::nullopt;
  }

  /// Faces may come before what they name.
  Result<ObjLines> finish() && {
    if (triangles_ == 0) return Failure{"there is no face in it"};
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
      const auto& [place, line] = largest_[kind];
      if (place > static_cast<int64_t>(counts_[kind])) {
        line_ = line;
        return fault(fmt::format("{} {} does not exist: there are {}", kKinds[kind], place, counts_[kind]));
      }
    }
    return std::move(kept_);
  }

 private:
  static constexpr std::array<std::string_view, 3> kKinds{"vertex", "texture coordinate", "normal"};
  static constexpr std::array<std::size_t, 3> kLeastNumbers{3, 1, 3};
  static constexpr std::array<std::string_view, 4> kKeywords{"v", "vt", "vn", "f"};

  Failure fault(std::string_view what) const { return Failure{fmt::format("line {}: {}", line_, what)}; }

  std::optional<Failure> check_numbers(std::string_view line, std::string_view keyword, std::size_t kind) {
    const std::size_t least = kLeastNumbers[kind];
    std::size_t count = 0;
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      if (const auto wrong = number_fault(word)) return fault(*wrong);
      ++count;
    }
    if (count < least) return fault(fmt::format("`{}` takes at least {} numbers, not {}", keyword, least, count));
    if (++counts_[kind] > kMaxObjVertices) {
      return fault(fmt::format("more than {} lines `{}`", kMaxObjVertices, keyword));
    }
    return std::nullopt;
  }

  /// What is longer, or has a larger exponent, tinyobjloader may read as another number, or as none.
  static std::optional<std::string> number_fault(std::string_view word) {
    if (word.size() > kLongestNumber) return fmt::format("'{}' is too long for a number", shown(word));
    std::string_view digits = word;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) {
      return fmt::format("'{}' is no number", shown(word));
    }
    if (error != std::errc{} || !(std::abs(number) <= kLargest) || has_large_exponent(digits)) {
      return fmt::format("'{}' is not between -1e18 and 1e18, or needs too large an exponent", shown(word));
    }
    return std::nullopt;
  }

  static bool has_large_exponent(std::string_view digits) {
    const std::size_t sign = digits.find_first_of("eE");
    if (sign == std::string_view::npos) return false;
    std::string_view exponent = digits.substr(sign + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    int value = 0;
    const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
    return error != std::errc{} || std::abs(value) > kLargestExponent;
  }

  std::optional<Failure> check_face(std::string_view line) {
    std::size_t corners = 0;
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      if (auto wrong = check_corner(word)) return wrong;
      ++corners;
    }
    if (corners < 3) return fault(fmt::format("a face has at least 3 corners, not {}", corners));
    if (corners > kMaxObjCorners) {
      return fault(fmt::format("a face of {} corners; more than {} are not read", corners, kMaxObjCorners));
    }
    triangles_ += corners - 2;
    if (triangles_ > kMaxObjTriangles) return fault(fmt::format("more than {} triangles", kMaxObjTriangles));
    return std::nullopt;
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::optional<Failure> check_corner(std::string_view word) {
    std::string_view rest = word;
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view number = rest.substr(0, slash);
      const bool may_lack = kind == 1 && slash < rest.size();
      if (!(number.empty() && may_lack)) {
        if (auto wrong = check_reference(word, number, kind)) return wrong;
      }
      if (slash == rest.size()) return std::nullopt;
      rest.remove_prefix(slash + 1);
    }
    return fault(fmt::format("'{}' is no corner of a face", shown(word)));
  }

  std::optional<Failure> check_reference(std::string_view word, std::string_view digits, std::size_t kind) {
    int32_t place = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), place);
    if (error != std::errc{} || end != digits.data() + digits.size()) {
      return fault(fmt::format("'{}' is no corner of a face", shown(word)));
    }
    const auto count = static_cast<int64_t>(counts_[kind]);
    if (place == 0) return fault("counting begins at 1, not at 0");
    if (place < 0 && -int64_t{place} > count) {
      return fault(fmt::format("{} {} does not exist: there are {} before it", kKinds[kind], place, count));
    }
    if (place > largest_[kind].place) largest_[kind] = {place, line_};
    return std::nullopt;
  }

  static constexpr double kLargest = 1e18;
  static constexpr std::size_t kLongestNumber = 60;
  static constexpr int kLargestExponent = 300;

  ObjLines kept_;
  std::size_t line_ = 0;
  std::array<std::size_t, 3> counts_{};
  std::array<Reference, 3> largest_{};
  std::size_t triangles_ = 0;
};

/// Takes the first line off a text; it ends at LF, CRLF or CR.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const std::size_t line_end = text.substr(end).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(std::min(end + line_end, text.size()));
  return line;
}

}  // namespace

Result<ObjLines> check_obj_lines(std::string_view text) {
  if (text.size() > kMaxObjBytes) return Failure{fmt::format("it is larger than {} MiB", kMaxObjBytes >> 20)};
  if (text.find('\0') != std::string_view::npos) return Failure{"it is no text"};
  LineChecker checker;
  std::string joined;
  std::size_t number = 0;
  std::size_t first = 1;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    ++number;
    if (line.ends_with('\\') && !text.empty()) {
      joined.append(line.substr(0, line.size() - 1)).append(" ");
      continue;
    }
    auto wrong = joined.empty() ? checker.check(line, number) : checker.check(joined.append(line), first);
    if (wrong) return *std::move(wrong);
    joined.clear();
    first = number + 1;
  }
  return std::move(checker).finish();
}

}  // namespace texbrdf::objects

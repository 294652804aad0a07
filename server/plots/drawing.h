#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "render/image.h"

namespace texbrdf::plots {

/// In pixels from the top left.
struct Point {
  double x = 0;
  double y = 0;
};

struct Rectangle {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// sRGB.
struct Colour {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
  double opacity = 1;
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct Stroke {
  Colour colour;
  double width = 1;
  std::vector<double> dashes = {};  ///< lengths of line and gap in turns; empty: a line without gaps
};

/// Lines one after the other. All are closed or none is.
struct Path {
  std::vector<std::vector<Point>> lines;
  bool is_closed = false;
  std::optional<Colour> fill = {};
  std::optional<Stroke> stroke = {};
};

enum class Script : uint8_t { Base, Sub, Super };
enum class Anchor : uint8_t { Start, Middle, End };

struct Run {
  std::string text;
  Script script = Script::Base;
};

using Runs = std::vector<Run>;

/// Text as it stands.
Runs plain(std::string_view text);
/// `_` and `^` before a character or braces make a subscript or a superscript.
Runs rich(std::string_view text);

struct Label {
  Point at;  ///< on the base line, at the anchor
  Anchor anchor = Anchor::Start;
  Runs runs;
  double size = 12;  ///< pixels
  Colour colour = {};
  bool is_upright = false;  ///< read from bottom to top
};

inline constexpr double kScriptSize = 0.7;    ///< of the text's
inline constexpr double kSubShift = 0.2;      ///< of the text's size, down
inline constexpr double kSuperShift = -0.35;  ///< up

/// A field of equal rectangles, each of one colour.
struct Picture {
  Rectangle place;
  render::ImageRgba8 cells;
};

using Shape = std::variant<Path, Label, Picture>;

/// What is drawn, from the bottom to the top, on white.
struct Drawing {
  uint32_t width = 0;
  uint32_t height = 0;
  std::string title;
  std::vector<Shape> shapes;
};

}  // namespace texbrdf::plots

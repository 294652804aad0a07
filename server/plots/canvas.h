#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plots/drawing.h"
#include "plots/font.h"

namespace texbrdf::plots {

inline constexpr Colour kInk{0x22, 0x22, 0x22};
inline constexpr Colour kFaint{0x66, 0x66, 0x66};
inline constexpr Colour kGridLines{0xdd, 0xdd, 0xdd};
inline constexpr Colour kWarning{0xa0, 0x3c, 0x00};
inline constexpr double kTextSize = 12;
inline constexpr double kSmallText = 11;
inline constexpr double kLineHeight = 16;

/// Adds shapes to a drawing.
class Canvas {
 public:
  Canvas(uint32_t width, uint32_t height, std::string title);

  double width() const { return drawing_.width; }
  double height() const { return drawing_.height; }
  const Font& font() const { return font_; }

  void add(Shape shape) { drawing_.shapes.push_back(std::move(shape)); }
  void line(Point from, Point to, const Stroke& stroke);
  void polyline(std::vector<Point> points, const Stroke& stroke);
  void circle(Point centre, double radius, Colour fill);
  void text(Point at, Anchor anchor, Runs runs, double size = kTextSize, Colour colour = kInk);

  Drawing take() { return std::move(drawing_); }

 private:
  Drawing drawing_;
  Font font_;
};

/// Part of a circle as points, degrees counted as on paper: 0 to the right, 90 up.
std::vector<Point> arc(Point centre, double radius, double from, double to);

}  // namespace texbrdf::plots

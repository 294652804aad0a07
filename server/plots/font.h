#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "plots/drawing.h"

namespace texbrdf::plots {

/// The bytes of the font that is part of the program; CMake writes it.
std::string_view font_file();

/// A step of an outline, in pixels from the start of the base line, y down.
struct OutlineStep {
  enum class Kind : uint8_t { Move, Line, Curve };
  Kind kind = Kind::Move;
  Point to;
  Point control = {};  ///< of a quadratic curve
};

/// DejaVu Sans, which has all letters that plots need.
class Font {
 public:
  Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;
  ~Font();

  /// In pixels. What is no UTF-8 counts as U+FFFD.
  double width_of(std::string_view text, double size) const;
  double width_of(const Runs& runs, double size) const;
  /// The glyphs from left to right.
  std::vector<OutlineStep> outline_of(std::string_view text, double size) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace texbrdf::plots

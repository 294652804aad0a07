#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/gl.h"
#include "source/result.h"

namespace texbrdf::render {

/// Points lie in rows of this many pixels, in textures and in the target.
inline constexpr uint32_t kTileWidth = 256;
inline constexpr uint32_t kTileHeight = 1024;
inline constexpr std::size_t kTilePoints = std::size_t{kTileWidth} * kTileHeight;

/// Three coordinates of some points.
using PointVectors = std::array<std::span<const float>, 3>;

/// A float target that fragment programs are run over, one pixel a point, and the textures with the points' vectors.
/// A byte per channel would lose NaN.
class TileTarget {
 public:
  static Result<TileTarget> create(const Gl& gl);

  /// Before drawing, where something else was drawn to since.
  void bind();
  /// At most kTilePoints points.
  void upload(uint32_t unit, const PointVectors& vectors);
  /// Runs the program over the first `points` points.
  void draw(GLuint fragment_program, std::size_t points);
  /// Appends four floats for each point.
  void read(std::size_t points, std::vector<float>& out);
  /// What OpenGL complains about since the last call, or nothing.
  std::optional<std::string> take_error();

 private:
  explicit TileTarget(const Gl& gl) : gl_(&gl) {}
  const Gl* gl_;
  GLuint framebuffer_ = 0;
  GLuint vertex_array_ = 0;
  GLuint pipeline_ = 0;
  GLuint vertex_program_ = 0;
  std::array<GLuint, 5> textures_{};
  std::vector<float> staging_;
};

}  // namespace texbrdf::render

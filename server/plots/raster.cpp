#include "plots/raster.h"

#include <agg_conv_curve.h>
#include <agg_conv_dash.h>
#include <agg_conv_stroke.h>
#include <agg_conv_transform.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_u.h>
#include <agg_trans_affine.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "plots/font.h"

namespace texbrdf::plots {
namespace {

using Pixels = agg::pixfmt_rgba32;
using Surface = agg::renderer_base<Pixels>;

agg::rgba8 agg_colour(const Colour& colour) {
  return {colour.red, colour.green, colour.blue, static_cast<unsigned>(std::lround(colour.opacity * 255))};
}

agg::path_storage agg_path(const Path& path) {
  agg::path_storage storage;
  for (const std::vector<Point>& line : path.lines) {
    if (line.empty()) continue;
    storage.move_to(line.front().x, line.front().y);
    for (const Point& point : std::span(line).subspan(1)) storage.line_to(point.x, point.y);
    if (path.is_closed) storage.close_polygon();
  }
  return storage;
}

class Rasteriser {
 public:
  explicit Rasteriser(render::ImageRgba8& image)
      : image_(image),
        buffer_(image.pixels.data(), image.width, image.height, static_cast<int>(image.width) * 4),
        pixels_(buffer_),
        surface_(pixels_) {
    surface_.clear(agg::rgba8(255, 255, 255));
    scan_.clip_box(0, 0, image.width, image.height);
  }

  void draw(const Path& path) {
    agg::path_storage storage = agg_path(path);
    if (path.fill) paint(storage, *path.fill);
    if (path.stroke) draw_stroke(storage, *path.stroke);
  }

  void draw(const Label& label) {
    double width = font_.width_of(label.runs, label.size);
    if (label.anchor == Anchor::Start) width = 0;
    double x = label.anchor == Anchor::Middle ? -width / 2 : -width;
    for (const Run& run : label.runs) {
      const double size = run.script == Script::Base ? label.size : label.size * kScriptSize;
      draw_run(label, run, x, size);
      x += font_.width_of(run.text, size);
    }
  }

  void draw(const Picture& picture) {
    const Rectangle& place = picture.place;
    const auto [left, right] = pixel_range(place.left, place.right, image_.width);
    const auto [top, bottom] = pixel_range(place.top, place.bottom, image_.height);
    for (uint32_t y = top; y < bottom; ++y) {
      const uint32_t row = cell_of(y, place.top, place.height(), picture.cells.height);
      for (uint32_t x = left; x < right; ++x) {
        const uint8_t* const cell = picture.cells.at(cell_of(x, place.left, place.width(), picture.cells.width), row);
        std::copy_n(cell, 4, &image_.pixels[(std::size_t{y} * image_.width + x) * 4]);
      }
    }
  }

 private:
  struct PixelRange {
    uint32_t first;
    uint32_t end;
  };

  /// The pixels whose middle is between two coordinates.
  static PixelRange pixel_range(double from, double to, uint32_t size) {
    const auto pixel = [&](double at) {
      return static_cast<uint32_t>(std::clamp<double>(std::ceil(at - 0.5), 0, size));
    };
    return {pixel(from), pixel(to)};
  }

  static uint32_t cell_of(uint32_t pixel, double from, double length, uint32_t cells) {
    const double part = (pixel + 0.5 - from) / length;
    return static_cast<uint32_t>(std::clamp(part * cells, 0.0, cells - 1.0));
  }

  template <typename Source>
  void paint(Source& source, const Colour& colour) {
    scan_.reset();
    scan_.add_path(source);
    agg::render_scanlines_aa_solid(scan_, line_, surface_, agg_colour(colour));
  }

  template <typename Source>
  void paint_outline(Source& source, const Stroke& stroke) {
    agg::conv_stroke<Source> outline(source);
    outline.width(stroke.width);
    outline.line_join(agg::round_join);
    outline.line_cap(agg::butt_cap);
    paint(outline, stroke.colour);
  }

  void draw_stroke(agg::path_storage& storage, const Stroke& stroke) {
    if (stroke.dashes.empty()) {
      paint_outline(storage, stroke);
      return;
    }
    agg::conv_dash<agg::path_storage> dashed(storage);
    for (std::size_t i = 0; i + 1 < stroke.dashes.size(); i += 2)
      dashed.add_dash(stroke.dashes[i], stroke.dashes[i + 1]);
    paint_outline(dashed, stroke);
  }

  void draw_run(const Label& label, const Run& run, double x, double size) {
    agg::path_storage storage;
    for (const OutlineStep& step : font_.outline_of(run.text, size)) {
      switch (step.kind) {
        case OutlineStep::Kind::Move:
          storage.move_to(step.to.x, step.to.y);
          break;
        case OutlineStep::Kind::Line:
          storage.line_to(step.to.x, step.to.y);
          break;
        case OutlineStep::Kind::Curve:
          storage.curve3(step.control.x, step.control.y, step.to.x, step.to.y);
          break;
      }
    }
    double shift = 0;
    if (run.script == Script::Sub) shift = kSubShift * label.size;
    if (run.script == Script::Super) shift = kSuperShift * label.size;
    agg::trans_affine place = agg::trans_affine_translation(x, shift);
    if (label.is_upright) place *= agg::trans_affine_rotation(-std::numbers::pi / 2);
    place *= agg::trans_affine_translation(label.at.x, label.at.y);
    agg::conv_curve<agg::path_storage> curves(storage);
    agg::conv_transform<agg::conv_curve<agg::path_storage>> placed(curves, place);
    paint(placed, label.colour);
  }

  render::ImageRgba8& image_;
  agg::rendering_buffer buffer_;
  Pixels pixels_;
  Surface surface_;
  agg::rasterizer_scanline_aa<> scan_;
  agg::scanline_u8 line_;
  Font font_;
};

}  // namespace

render::ImageRgba8 rasterise(const Drawing& drawing) {
  render::ImageRgba8 image{.width = drawing.width, .height = drawing.height, .pixels = {}};
  image.pixels.resize(std::size_t{image.width} * image.height * 4);
  Rasteriser rasteriser(image);
  for (const Shape& shape : drawing.shapes) {
    std::visit([&](const auto& one) { rasteriser.draw(one); }, shape);
  }
  return image;
}

}  // namespace texbrdf::plots

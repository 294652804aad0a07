#include "plots/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <span>

#include "render/base64.h"
#include "render/png.h"
#include "syntax/xml_text.h"

namespace texbrdf::plots {
namespace {

/// The shortest digits of a coordinate to a hundredth.
double rounded(double coordinate) {
  return std::round(coordinate * 100) / 100 + 0.0;
}

class SvgWriter {
 public:
  std::string write(const Drawing& drawing) {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        drawing.width, drawing.height, xml_text(drawing.title));
    for (const Shape& shape : drawing.shapes) {
      std::visit([&](const auto& one) { write_shape(one); }, shape);
    }
    add("</svg>\n");
    return fmt::to_string(out_);
  }

 private:
  template <typename... Parts>
  void add(fmt::format_string<const Parts&...> format, const Parts&... parts) {
    fmt::format_to(std::back_inserter(out_), format, parts...);
  }

  void add_colour(std::string_view attribute, const Colour& colour) {
    add(" {}=\"#{:02x}{:02x}{:02x}\"", attribute, colour.red, colour.green, colour.blue);
    if (colour.opacity != 1) add(" {}-opacity=\"{}\"", attribute, rounded(colour.opacity));
  }

  void write_shape(const Path& path) {
    add("<path");
    if (path.fill) add_colour("fill", *path.fill);
    if (!path.fill) add(" fill=\"none\"");
    if (path.stroke) add_stroke(*path.stroke);
    add(" d=\"");
    for (const std::vector<Point>& line : path.lines) add_line(line, path.is_closed);
    add("\"/>\n");
  }

  void add_stroke(const Stroke& stroke) {
    add_colour("stroke", stroke.colour);
    if (stroke.width != 1) add(" stroke-width=\"{}\"", rounded(stroke.width));
    add(" stroke-linejoin=\"round\"");
    if (stroke.dashes.empty()) return;
    add(" stroke-dasharray=\"");
    for (std::size_t i = 0; i < stroke.dashes.size(); ++i) add("{}{}", i == 0 ? "" : " ", stroke.dashes[i]);
    add("\"");
  }

  void add_line(std::span<const Point> line, bool is_closed) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      add("{}{} {}", i == 0 ? "M" : "L", rounded(line[i].x), rounded(line[i].y));
    }
    if (is_closed) add("Z");
  }

  void write_shape(const Label& label) {
    add("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", rounded(label.at.x), rounded(label.at.y), rounded(label.size));
    if (label.anchor != Anchor::Start) add(" text-anchor=\"{}\"", label.anchor == Anchor::Middle ? "middle" : "end");
    if (label.colour != Colour{}) add_colour("fill", label.colour);
    if (label.is_upright) add(" transform=\"rotate(-90 {} {})\"", rounded(label.at.x), rounded(label.at.y));
    add(">");
    double shift = 0;
    for (const Run& run : label.runs) {
      shift = add_run(run, label.size, shift);
    }
    add("</text>\n");
  }

  /// `shift`: how far below the base line the run before stands, in pixels; returns that of this one.
  double add_run(const Run& run, double size, double shift) {
    double target = 0;
    if (run.script == Script::Sub) target = kSubShift * size;
    if (run.script == Script::Super) target = kSuperShift * size;
    if (target == shift && run.script == Script::Base) {
      add("{}", xml_text(run.text));
      return target;
    }
    add("<tspan dy=\"{}\"", rounded(target - shift));
    if (run.script != Script::Base) add(" font-size=\"{}\"", rounded(size * kScriptSize));
    add(">{}</tspan>", xml_text(run.text));
    return target;
  }

  void write_shape(const Picture& picture) {
    const Rectangle& place = picture.place;
    add("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>\n",
        rounded(place.left), rounded(place.top), rounded(place.width()), rounded(place.height()),
        render::base64(render::encode_png(picture.cells, render::PngEffort::Small)));
  }

  fmt::memory_buffer out_;
};

}  // namespace

std::string write_svg(const Drawing& drawing) {
  return SvgWriter().write(drawing);
}

}  // namespace texbrdf::plots

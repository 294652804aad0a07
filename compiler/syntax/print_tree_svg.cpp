#include "syntax/print_tree_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/tree_layout.h"
#include "syntax/xml_text.h"

namespace texbrdf {
namespace {

// All in px.
constexpr double kMargin = 20;
constexpr double kHeadingHeight = 34;
constexpr double kDrawingGap = 36;

constexpr std::string_view kStyle =
    "text{font-family:'DejaVu Sans Mono','Menlo','Consolas',monospace;text-anchor:middle;fill:#1b1f24}"
    ".title{font-size:14px;font-weight:600}.subtitle{font-size:11px;fill:#57606a}"
    ".heading{font-size:16px;font-weight:600;text-anchor:start}"
    ".box{fill:#f6f8fa;stroke:#8c959f;stroke-width:1}.edge{fill:none;stroke:#8c959f;stroke-width:1.2}";

struct Size {
  double width = 0;
  double height = 0;
};

struct LaidOutDrawing {
  const TreeDrawing* drawing;
  std::vector<TreeBox> boxes;
  Size size;
};

LaidOutDrawing lay_out(const TreeDrawing& drawing) {
  LaidOutDrawing laid{&drawing, layout_tree(*drawing.tree, drawing.root, drawing.label), {}};
  for (const TreeBox& box : laid.boxes) {
    laid.size.width = std::max(laid.size.width, box.x + box.width);
    laid.size.height = std::max(laid.size.height, box.y + box.height);
  }
  laid.size.width = std::max(laid.size.width, text_width(drawing.heading, kHeadingFontSize));
  laid.size.height += kHeadingHeight;
  return laid;
}

void write_edges(std::string& out, const LaidOutDrawing& laid, double left, double top) {
  std::vector<const TreeBox*> box_of(laid.drawing->tree->size(), nullptr);
  for (const TreeBox& box : laid.boxes) box_of[box.node.value] = &box;
  for (const TreeBox& parent : laid.boxes) {
    for (const NodeId child_id : laid.drawing->tree->children(parent.node)) {
      const TreeBox& child = *box_of[child_id.value];
      const double x1 = left + parent.x + parent.width / 2;
      const double y1 = top + parent.y + parent.height;
      const double x2 = left + child.x + child.width / 2;
      const double y2 = top + child.y;
      const double middle = (y1 + y2) / 2;
      fmt::format_to(std::back_inserter(out),
                     "<path class=\"edge\" d=\"M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\"/>\n", x1, y1,
                     x1, middle, x2, middle, x2, y2);
    }
  }
}

void write_text(std::string& out, std::string_view style, double x, double y, std::string_view text) {
  fmt::format_to(std::back_inserter(out), "<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", style, x, y,
                 xml_text(text));
}

void write_boxes(std::string& out, const LaidOutDrawing& laid, double left, double top) {
  for (const TreeBox& box : laid.boxes) {
    const NodeLabel label = shown_label(laid.drawing->label(box.node));
    const double x = left + box.x;
    const double y = top + box.y;
    const double centre = x + box.width / 2;
    fmt::format_to(std::back_inserter(out),
                   "<rect class=\"box\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"5\"/>\n", x,
                   y, box.width, box.height);
    write_text(out, "title", centre, y + kTitleBaseline, label.title);
    if (!label.subtitle.empty()) write_text(out, "subtitle", centre, y + kSubtitleBaseline, label.subtitle);
  }
}

}  // namespace

std::string print_tree_svg(const std::vector<TreeDrawing>& drawings) {
  std::vector<LaidOutDrawing> laid;
  Size page{0, kMargin};
  for (const TreeDrawing& drawing : drawings) {
    laid.push_back(lay_out(drawing));
    page.width = std::max(page.width, laid.back().size.width);
    page.height += laid.back().size.height + kDrawingGap;
  }
  page.width += 2 * kMargin;

  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  fmt::format_to(std::back_inserter(out),
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                 "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<style>{2}</style>\n"
                 "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
                 page.width, page.height, kStyle);
  double top = kMargin;
  for (const LaidOutDrawing& drawing : laid) {
    write_text(out, "heading", kMargin, top + kHeadingFontSize, shown_heading(drawing.drawing->heading));
    write_edges(out, drawing, kMargin, top + kHeadingHeight);
    write_boxes(out, drawing, kMargin, top + kHeadingHeight);
    top += drawing.size.height + kDrawingGap;
  }
  out += "</svg>\n";
  return out;
}

}  // namespace texbrdf

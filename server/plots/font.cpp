#include "plots/font.h"

#include <stb/stb_truetype.h>
#include <utf8.h>

#include "source/internal_error.h"

namespace texbrdf::plots {

struct Font::Face {
  stbtt_fontinfo info{};
};

namespace {

double scale_of(const stbtt_fontinfo& info, double size) {
  return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
}

std::u32string code_points(std::string_view text) {
  return utf8::utf8to32(utf8::replace_invalid(text));
}

/// Calls `visit` with each glyph and where it starts, in units of the font; returns the width.
template <typename Visit>
int for_each_glyph(const stbtt_fontinfo& info, std::string_view text, const Visit& visit) {
  int x = 0;
  int before = 0;
  for (const char32_t code_point : code_points(text)) {
    const int glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(code_point));
    if (before != 0) x += stbtt_GetGlyphKernAdvance(&info, before, glyph);
    visit(glyph, x);
    int advance = 0;
    int bearing = 0;
    stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
    x += advance;
    before = glyph;
  }
  return x;
}

OutlineStep step_of(const stbtt_vertex& vertex, int start, double scale) {
  const auto point = [&](int x, int y) { return Point{(start + x) * scale, -y * scale}; };
  OutlineStep step{.to = point(vertex.x, vertex.y)};
  if (vertex.type == STBTT_vline) step.kind = OutlineStep::Kind::Line;
  if (vertex.type == STBTT_vcurve) {
    step.kind = OutlineStep::Kind::Curve;
    step.control = point(vertex.cx, vertex.cy);
  }
  return step;
}

}  // namespace

Font::Font() : face_(std::make_unique<Face>()) {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(font_file().data());
  require(stbtt_InitFont(&face_->info, bytes, 0) != 0, "the font of the program cannot be read");
}

Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;
Font::~Font() = default;

double Font::width_of(std::string_view text, double size) const {
  return for_each_glyph(face_->info, text, [](int, int) {}) * scale_of(face_->info, size);
}

double Font::width_of(const Runs& runs, double size) const {
  double width = 0;
  for (const Run& run : runs) width += width_of(run.text, run.script == Script::Base ? size : size * kScriptSize);
  return width;
}

std::vector<OutlineStep> Font::outline_of(std::string_view text, double size) const {
  const double scale = scale_of(face_->info, size);
  std::vector<OutlineStep> outline;
  for_each_glyph(face_->info, text, [&](int glyph, int start) {
    stbtt_vertex* vertices = nullptr;
    const int count = stbtt_GetGlyphShape(&face_->info, glyph, &vertices);
    for (int i = 0; i < count; ++i) outline.push_back(step_of(vertices[i], start, scale));
    stbtt_FreeShape(&face_->info, vertices);
  });
  return outline;
}

}  // namespace texbrdf::plots

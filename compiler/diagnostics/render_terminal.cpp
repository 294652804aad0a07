#include "diagnostics/render_terminal.h"

#include <algorithm>

#include "source/utf8.h"

namespace texbrdf {
namespace {

constexpr std::string_view kReset = "\x1b[0m";
constexpr std::string_view kBold = "\x1b[1m";
constexpr std::string_view kNoteColour = "\x1b[36m";

/// A longer line is cut around the range; in code points.
constexpr uint32_t kWidestExcerpt = 160;
constexpr std::string_view kTab = "    ";

std::string_view colour_of(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "\x1b[1;31m";
    case Severity::Warning:
      return "\x1b[1;33m";
    case Severity::Information:
      return "\x1b[1;36m";
    case Severity::Hint:
      return "\x1b[1;34m";
  }
  return {};
}

class TerminalRenderer {
 public:
  TerminalRenderer(const PlaceFinder& find_place, TerminalStyle style) : find_place_(find_place), style_(style) {}

  std::string render(const Diagnostic& diagnostic) {
    const std::string_view colour = colour_of(diagnostic.severity);
    const Place place = find_place_(diagnostic.where);
    write_head(place, severity_name(diagnostic.severity), colour,
               message(diagnostic) + " [" + code_name(diagnostic.code) + "]");
    write_excerpt(place, colour);
    for (const RelatedPlace& related : diagnostic.related) {
      const Place there = find_place_(related.where);
      write_head(there, "note", kNoteColour, related.message);
      write_excerpt(there, kNoteColour);
    }
    for (const Fix& fix : diagnostic.fixes) {
      painted("fix", kNoteColour);
      out_ += ": " + printable(fix.title) + "\n";
    }
    return std::move(out_);
  }

 private:
  void painted(std::string_view text, std::string_view colour) {
    if (style_.colour) out_ += colour;
    out_ += text;
    if (style_.colour) out_ += kReset;
  }

  void write_head(const Place& place, std::string_view label, std::string_view colour, std::string_view text) {
    const Position position = place.text->position(place.span.begin, ColumnUnit::CodePoint);
    painted(std::string(place.file) + "(" + std::to_string(position.line + 1) + ":" +
                std::to_string(position.column + 1) + ")",
            kBold);
    out_ += ' ';
    painted(label, colour);
    out_ += ": " + printable(text) + "\n";
  }

  /// The line before, the line, and carets under what of the range lies on it.
  void write_excerpt(const Place& place, std::string_view colour) {
    const SourceText& text = *place.text;
    const uint32_t line_number = text.position(place.span.begin, ColumnUnit::Utf8).line;
    const std::string line = text.line(line_number);
    const auto length = static_cast<uint32_t>(line.size());
    const uint32_t line_start = text.line_start(line_number);
    const uint32_t begin = std::min(place.span.begin - line_start, length);
    const uint32_t end = std::clamp(place.span.end - line_start, begin, length);
    const Span window = window_around(line, begin, end);

    if (line_number > 0) {
      const std::string before = text.line(line_number - 1);
      out_ += excerpt(before, window_around(before, 0, 0)) + "\n";
    }
    const std::string lead = excerpt(line, {window.begin, begin});
    const std::string marked = printable(line.substr(begin, std::min(end, window.end) - begin), kTab);
    out_ += lead + marked + excerpt_tail(line, std::min(end, window.end), window.end) + "\n";
    out_.append(count_code_points(lead), ' ');
    painted(std::string(std::max(count_code_points(marked), uint32_t{1}), '^'), colour);
    out_ += "\n";
  }

  static std::string excerpt(std::string_view line, Span part) {
    const std::string_view lead = part.begin > 0 ? "…" : "";
    return std::string(lead) + printable(line.substr(part.begin, part.size()), kTab);
  }

  static std::string excerpt_tail(std::string_view line, uint32_t begin, uint32_t end) {
    return printable(line.substr(begin, end - begin), kTab) + (end < line.size() ? "…" : "");
  }

  /// The bytes of the line to show: all, or so many code points that the start of the range is among them.
  static Span window_around(std::string_view line, uint32_t begin, uint32_t end) {
    const auto size = static_cast<uint32_t>(line.size());
    if (size <= kWidestExcerpt) return {0, size};
    const uint32_t context = kWidestExcerpt / 3;
    uint32_t first = begin > context ? begin - context : 0;
    uint32_t last = std::min(size, std::min(std::max(end, begin + context), first + kWidestExcerpt));
    auto inside_code_point = [&](uint32_t at) {
      return at > 0 && at < size && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80;
    };
    while (first < begin && inside_code_point(first)) ++first;
    while (last < size && inside_code_point(last)) ++last;
    return {first, last};
  }

  const PlaceFinder& find_place_;
  TerminalStyle style_;
  std::string out_;
};

}  // namespace

std::string render_terminal(const Diagnostic& diagnostic, const PlaceFinder& find_place, TerminalStyle style) {
  return TerminalRenderer(find_place, style).render(diagnostic);
}

}  // namespace texbrdf

#include "features/folding_ranges.h"

#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

/// For clients that fold whole lines: the line of the \end stays.
void write_lines(JsonWriter& out, Range inside, bool has_end) {
  const uint32_t last = inside.end.line - (has_end ? 1 : 0);
  if (last == inside.start.line) return;
  out.begin_object();
  out.member("startLine", inside.start.line);
  out.member("endLine", last);
  out.end_object();
}

void write_inside(JsonWriter& out, Range inside) {
  out.begin_object();
  out.member("startLine", inside.start.line);
  out.member("startCharacter", inside.start.column);
  out.member("endLine", inside.end.line);
  out.member("endCharacter", inside.end.column);
  out.end_object();
}

}  // namespace

Session::Outcome Session::folding_range(const DocumentParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  Positions positions(snapshot.text(), unit_);
  result.begin_array();
  for (const features::Fold& fold : features::folding_ranges(snapshot)) {
    const Range inside = positions.range(fold.inside);
    if (client_.folds_lines_only) {
      write_lines(result, inside, fold.has_end);
    } else {
      write_inside(result, inside);
    }
  }
  result.end_array();
  return std::nullopt;
}

}  // namespace texbrdf::lsp

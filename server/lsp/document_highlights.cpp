#include "features/document_highlights.h"

#include "lsp/session.h"

namespace texbrdf::lsp {

Session::Outcome Session::document_highlight(const PositionParams& params, JsonWriter& result) {
  constexpr int kRead = 2;
  constexpr int kWrite = 3;
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const uint32_t offset = snapshot.text().offset(params.position, unit_);
  Positions positions(snapshot.text(), unit_);
  result.begin_array();
  for (const features::Highlight& highlight : features::document_highlights(snapshot, offset)) {
    result.begin_object();
    write_range(result, "range", positions.range(highlight.span));
    result.member("kind", highlight.writes ? kWrite : kRead);
    result.end_object();
  }
  result.end_array();
  return std::nullopt;
}

}  // namespace texbrdf::lsp

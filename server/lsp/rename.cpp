#include "features/rename.h"

#include "lsp/session.h"
#include "lsp/write_edits.h"

namespace texbrdf::lsp {
Session::Outcome Session::prepare_rename(const PositionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const auto found = features::renamable_at(snapshot, snapshot.text().offset(params.position, unit_));
  if (!found) return ResponseError{ErrorCode::RequestFailed, found.error()};
  const std::optional<features::RenameTarget>& target = *found;
  if (!target) {
    result.null();
    return std::nullopt;
  }
  Positions positions(snapshot.text(), unit_);
  result.begin_object();
  write_range(result, "range", positions.range(target->span));
  result.member("placeholder", target->text);
  result.end_object();
  return std::nullopt;
}

Session::Outcome Session::rename(const RenameParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const auto edits = features::rename(snapshot, snapshot.text().offset(params.position, unit_), params.new_name);
  if (!edits) return ResponseError{ErrorCode::RequestFailed, edits.error()};
  Positions places = positions(*open);
  write_workspace_edit(result, places, by_file(*open, *edits), client_.versioned_edits);
  return std::nullopt;
}

}  // namespace texbrdf::lsp

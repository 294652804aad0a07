#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "analysis/snapshot.h"
#include "lsp/protocol.h"
#include "source/position_walk.h"
#include "source/span.h"

namespace texbrdf::lsp {

/// Byte offsets of a text as positions of the protocol. Of a snapshot, also those in other files of its project.
class Positions {
 public:
  Positions(const SourceText& text, ColumnUnit unit) : own_(text, unit), unit_(unit) {}
  using UriOf = std::function<std::string(FileId)>;
  Positions(const Snapshot& snapshot, ColumnUnit unit, UriOf uri_of)
      : own_(snapshot.text(), unit), unit_(unit), snapshot_(&snapshot), uri_of_(std::move(uri_of)) {}

  Position at(uint32_t offset) { return own_.at(offset); }
  Range range(Span span) {
    if (!is_elsewhere(span)) return {at(span.begin), at(span.end)};
    const FilePlace place = snapshot_->place(span);
    const SourceText& text = snapshot_->text(place.file);
    return {text.position(place.span.begin, unit_), text.position(place.span.end, unit_)};
  }

  bool is_elsewhere(Span span) const { return snapshot_ != nullptr && !snapshot_->is_in_file(span); }
  std::string uri_elsewhere(Span span) const { return uri_of_(snapshot_->place(span).file); }

 private:
  PositionWalk own_;
  ColumnUnit unit_;
  const Snapshot* snapshot_ = nullptr;
  UriOf uri_of_;
};

}  // namespace texbrdf::lsp

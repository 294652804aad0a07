#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "analysis/snapshot.h"

namespace texbrdf {

/// A document that is edited. An edit costs what it changes, whatever the size of the document: blocks and definitions
/// that it cannot affect are kept from the snapshot before.
/// One thread owns it; snapshots may be read by any other.
class Document {
 public:
  explicit Document(std::string_view text);
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  /// Replaces bytes [span.begin, span.end) of the text; offsets beyond the end are taken as the end.
  void replace(Span span, std::string_view replacement);
  void set_text(std::string_view text);
  const SourceText& text() const;

  /// The state now. Computed at most once between edits.
  const Snapshot& snapshot();
  /// Does now what the first edit or the first search for references would do otherwise.
  void prepare_for_edits();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf

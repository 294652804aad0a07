#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "analysis/snapshot.h"

namespace texbrdf {

/// A document that is edited. Blocks and definitions that an edit cannot affect are kept from the snapshot before.
/// One thread owns it; snapshots may be read by any other.
class Document {
 public:
  explicit Document(std::string text);
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  /// Replaces bytes [span.begin, span.end) of the text; offsets beyond the end are taken as the end.
  void replace(Span span, std::string_view replacement);
  void set_text(std::string text);
  const SourceText& text() const;

  /// The state now. Computed at most once between edits.
  const Snapshot& snapshot();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf

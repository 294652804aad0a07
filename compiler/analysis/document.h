#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "analysis/include.h"
#include "analysis/snapshot.h"
#include "source/text_language.h"

namespace texbrdf {

/// A document that is edited, or a project of several files that share their definitions. An edit costs what it
/// changes, whatever the size of the document: blocks and definitions that it cannot affect are kept from the snapshot
/// before. One thread owns it; snapshots may be read by any other.
class Document {
 public:
  explicit Document(std::string_view text, TextLanguage language = TextLanguage::Latex)
      : Document(SourceText(text), language) {}
  explicit Document(SourceText text, TextLanguage language = TextLanguage::Latex);
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  /// Replaces bytes [span.begin, span.end) of the text; offsets beyond the end are taken as the end.
  void replace(Span span, std::string_view replacement) { replace(FileId{}, span, replacement); }
  void replace(FileId file, Span span, std::string_view replacement);
  void set_text(std::string_view text) { set_text(FileId{}, text); }
  void set_text(FileId file, std::string_view text);
  const SourceText& text(FileId file = {}) const;
  TextLanguage language(FileId file = {}) const;
  /// Costs as much as a new document where it is another.
  void set_language(FileId file, TextLanguage language);

  uint32_t file_count() const;
  /// The files from there on come behind it. The first file stays the first.
  void insert_file(FileId at, const SourceText& text, TextLanguage language = TextLanguage::Latex);
  void remove_file(FileId file);
  /// What the prose of the file includes, in its order.
  std::vector<IncludeTarget> includes(FileId file = {}) const;
  /// Includes that could not be followed; they are reported where they stand.
  void set_include_problems(std::vector<IncludeProblem> problems);

  /// The state now, seen from one of the files. Computed at most once between edits.
  const Snapshot& snapshot(FileId file = {});
  /// Does now what the first edit or the first search for references would do otherwise.
  void prepare_for_edits();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "source/source_text.h"
#include "source/span.h"
#include "source/text_language.h"

namespace texbrdf {

/// The texts of a project's files, one after the other. Between two files is a byte that belongs to neither, so that
/// an offset tells the end of a file from the begin of the next.
class ProjectText {
 public:
  ProjectText() = default;
  ProjectText(SourceText text, TextLanguage language) : files_{std::move(text)}, begins_{0}, languages_{language} {}

  uint32_t file_count() const { return static_cast<uint32_t>(files_.size()); }
  const SourceText& file(FileId id) const { return files_[id.value]; }
  TextLanguage language(FileId id) const { return languages_[id.value]; }
  uint32_t begin(FileId id) const { return begins_[id.value]; }
  Span span(FileId id) const { return {begin(id), begin(id) + file(id).size()}; }
  uint32_t size() const { return files_.empty() ? 0 : span({file_count() - 1}).end; }
  /// The file that the offset lies in or at the end of.
  FileId file_at(uint32_t offset) const;
  /// Of one file.
  std::string slice(Span span) const;
  std::string bytes() const;

  void set(FileId id, SourceText text);
  void set_language(FileId id, TextLanguage language) { languages_[id.value] = language; }
  void insert(FileId id, SourceText text, TextLanguage language);
  void remove(FileId id);

 private:
  void place_from(uint32_t file);

  std::vector<SourceText> files_;
  std::vector<uint32_t> begins_;
  std::vector<TextLanguage> languages_;
};

}  // namespace texbrdf

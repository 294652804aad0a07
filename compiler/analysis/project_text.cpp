#include "analysis/project_text.h"

#include <algorithm>

namespace texbrdf {

FileId ProjectText::file_at(uint32_t offset) const {
  const auto behind = std::ranges::upper_bound(begins_, offset);
  return {static_cast<uint32_t>(behind - begins_.begin()) - 1};
}

std::string ProjectText::slice(Span span) const {
  const FileId id = file_at(span.begin);
  return file(id).slice({span.begin - begin(id), span.end - begin(id)});
}

std::string ProjectText::bytes() const {
  std::string all;
  all.reserve(size());
  for (const SourceText& text : files_) {
    if (&text != files_.data()) all += '\n';
    all += text.bytes();
  }
  return all;
}

void ProjectText::set(FileId id, SourceText text) {
  files_[id.value] = std::move(text);
  place_from(id.value + 1);
}

void ProjectText::insert(FileId id, SourceText text, TextLanguage language) {
  files_.insert(files_.begin() + id.value, std::move(text));
  languages_.insert(languages_.begin() + id.value, language);
  begins_.push_back(0);
  place_from(id.value);
}

void ProjectText::remove(FileId id) {
  files_.erase(files_.begin() + id.value);
  languages_.erase(languages_.begin() + id.value);
  begins_.pop_back();
  place_from(id.value);
}

void ProjectText::place_from(uint32_t file) {
  for (uint32_t i = file; i < file_count(); ++i) begins_[i] = i == 0 ? 0 : span({i - 1}).end + 1;
}

}  // namespace texbrdf

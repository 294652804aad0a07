#include "lsp/documents.h"

#include <utility>

namespace texbrdf::lsp {

OpenDocument& Documents::open(std::string uri, std::string text, int64_t version) {
  close(uri);
  OpenDocument document{uri, Document(std::move(text)), version};
  return documents_.emplace(std::move(uri), std::move(document)).first->second;
}

bool Documents::close(std::string_view uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return false;
  documents_.erase(found);
  return true;
}

OpenDocument* Documents::find(std::string_view uri) {
  const auto found = documents_.find(uri);
  return found == documents_.end() ? nullptr : &found->second;
}

OpenDocument* Documents::next_unpublished() {
  for (auto& [uri, document] : documents_) {
    if (!document.published) return &document;
  }
  return nullptr;
}

}  // namespace texbrdf::lsp

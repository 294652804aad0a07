#include "lsp/documents.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

constexpr auto kMarkdownIds = std::to_array<std::string_view>({"markdown", "mdx", "rmd", "rmarkdown", "quarto"});
constexpr auto kLatexIds = std::to_array<std::string_view>({"latex", "tex"});

TextLanguage language_of(std::string_view id, std::string_view path) {
  if (std::ranges::find(kMarkdownIds, id) != kMarkdownIds.end()) return TextLanguage::Markdown;
  if (std::ranges::find(kLatexIds, id) != kLatexIds.end()) return TextLanguage::Latex;
  return language_of_path(path);
}

}  // namespace

OpenDocument& Documents::open(std::string uri, std::string_view text, int64_t version, std::string_view language_id) {
  close(uri);
  const bool is_file = uri.starts_with("file:");
  std::string path = is_file ? files::real_path(shown_path(uri)) : uri;
  const TextLanguage language = language_of(language_id, path);
  Buffer& buffer = projects_.open(std::move(path), SourceText(text), language);
  OpenDocument document{uri, ProjectDocument(projects_, buffer), version};
  return documents_.emplace(std::move(uri), std::move(document)).first->second;
}

bool Documents::close(std::string_view uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return false;
  projects_.close(found->second.document.buffer());
  documents_.erase(found);
  return true;
}

OpenDocument* Documents::find(std::string_view uri) {
  const auto found = documents_.find(uri);
  return found == documents_.end() ? nullptr : &found->second;
}

OpenDocument* Documents::find_path(std::string_view path) {
  for (auto& [uri, document] : documents_) {
    if (document.document.buffer().path == path) return &document;
  }
  return nullptr;
}

void Documents::start_anew() {
  projects_.start_anew();
  for (auto& [uri, document] : documents_) {
    document.shown_state = 0;
    document.lacks_findings = false;
    document.semantic_tokens = {};
    document.symbols = {};
    document.name_index = {};
  }
}

OpenDocument* Documents::next_unpublished() {
  for (auto& [uri, document] : documents_) {
    if (!document.published) return &document;
  }
  return nullptr;
}

}  // namespace texbrdf::lsp

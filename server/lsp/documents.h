#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/name_index.h"
#include "lsp/projects.h"
#include "lsp/semantic_token_cache.h"
#include "lsp/symbol_cache.h"

namespace texbrdf::lsp {

struct OpenDocument {
  std::string uri;
  ProjectDocument document;
  std::optional<int64_t> version;
  bool published = false;       ///< the client has the diagnostics of this version
  bool lacks_findings = false;  ///< what was published or pulled last did not have all that is computed
  uint64_t shown_state = 0;     ///< of its project when they were published
  std::string items = {};       ///< what was published, of a project with several files
  uint64_t pulled_id = 0;       ///< of the last result that the client pulled; 0: none
  std::string pulled = {};      ///< that result's diagnostics as JSON
  uint64_t touched = 0;         ///< the larger, the later it was opened or edited

  SemanticTokenCache semantic_tokens = {};
  SymbolCache symbols = {};
  features::NameIndex name_index = {};
};

/// The documents that the client has open, by their URIs as the client writes them.
class Documents {
 public:
  /// `language_id`: as the client names it; where that says nothing, the path decides.
  OpenDocument& open(std::string uri, std::string_view text, int64_t version, std::string_view language_id);
  /// False where it was not open.
  bool close(std::string_view uri);
  void clear() {
    while (!documents_.empty()) close(documents_.begin()->first);
  }
  /// nullptr where it is not open.
  OpenDocument* find(std::string_view uri);

  std::map<std::string, OpenDocument, std::less<>>& all() { return documents_; }
  /// A document whose diagnostics the client lacks; nullptr where it has all.
  OpenDocument* next_unpublished();
  /// nullptr where none is the file.
  OpenDocument* find_path(std::string_view path);

  Projects& projects() { return projects_; }
  /// Forms all that is known of the documents anew from their texts.
  void start_anew();

 private:
  Projects projects_;
  std::map<std::string, OpenDocument, std::less<>> documents_;
};

}  // namespace texbrdf::lsp

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "features/name_index.h"
#include "lsp/semantic_token_cache.h"

namespace texbrdf::lsp {

struct OpenDocument {
  std::string uri;
  Document document;
  std::optional<int64_t> version;
  bool published = false;   ///< the client has the diagnostics of this version
  uint64_t pulled_id = 0;   ///< of the last result that the client pulled; 0: none
  std::string pulled = {};  ///< that result's diagnostics as JSON

  SemanticTokenCache semantic_tokens = {};
  features::NameIndex name_index = {};
};

/// The documents that the client has open, by their URIs as the client writes them.
class Documents {
 public:
  OpenDocument& open(std::string uri, std::string text, int64_t version);
  /// False where it was not open.
  bool close(std::string_view uri);
  /// nullptr where it is not open.
  OpenDocument* find(std::string_view uri);

  std::map<std::string, OpenDocument, std::less<>>& all() { return documents_; }
  /// A document whose diagnostics the client lacks; nullptr where it has all.
  OpenDocument* next_unpublished();

 private:
  std::map<std::string, OpenDocument, std::less<>> documents_;
};

}  // namespace texbrdf::lsp

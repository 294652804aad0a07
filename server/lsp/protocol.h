#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "source/source_text.h"

namespace texbrdf::lsp {

/// The parameters of the protocol's messages, as far as they are in use. Positions count columns in the encoding that
/// was negotiated.

struct Range {
  Position start;
  Position end;
};

struct NoParams {};

struct InitializeParams {
  std::optional<int64_t> process_id;
  std::string client_name;
  std::string client_version;
  std::vector<std::string> position_encodings;  ///< in the client's order of preference
  std::vector<std::string> hover_formats;       ///< "markdown", "plaintext", in order of preference
  bool definition_links = false;
  bool hierarchical_symbols = false;
  bool related_information = false;
  bool code_description = false;
};

struct DidOpenParams {
  std::string uri;
  std::string language_id;
  int64_t version = 0;
  std::string text;
};

struct ContentChange {
  std::optional<Range> range;  ///< nothing: the whole document
  std::string text;
};

struct DidChangeParams {
  std::string uri;
  std::optional<int64_t> version;
  std::vector<ContentChange> changes;
};

struct DocumentParams {
  std::string uri;
};

struct PositionParams {
  std::string uri;
  Position position;
};

struct ReferenceParams {
  std::string uri;
  Position position;
  bool include_declaration = false;
};

}  // namespace texbrdf::lsp

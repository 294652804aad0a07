#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "features/text_edit.h"
#include "lsp/json_writer.h"
#include "lsp/positions.h"

namespace texbrdf::lsp {

/// The changes to one file. Spans are those that the positions are made from.
struct FileEdits {
  std::string uri;
  std::optional<int64_t> version;  ///< nothing where the client does not have the file open
  std::vector<features::TextEdit> edits;
};

/// `versioned`: for clients that check that their text is still the one that was asked about.
void write_workspace_edit(JsonWriter& out, Positions& positions, std::span<const FileEdits> files, bool versioned);

}  // namespace texbrdf::lsp

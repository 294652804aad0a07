#pragma once

#include <span>

#include "features/text_edit.h"
#include "lsp/documents.h"
#include "lsp/json_writer.h"
#include "lsp/positions.h"

namespace texbrdf::lsp {

/// WorkspaceEdit of one document. `versioned`: for clients that check that their text is still the one that was asked
/// about.
void write_workspace_edit(JsonWriter& out, Positions& positions, const OpenDocument& open,
                          std::span<const features::TextEdit> edits, bool versioned);

}  // namespace texbrdf::lsp

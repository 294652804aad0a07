#pragma once

#include "lsp/json_writer.h"

namespace texbrdf::lsp {

/// SignatureHelpOptions, into an object that is open.
void write_signature_help_options(JsonWriter& out);

}  // namespace texbrdf::lsp

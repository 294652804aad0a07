#pragma once

#include "lsp/json_writer.h"
#include "lsp/protocol.h"
#include "lsp/providers.h"

namespace texbrdf::lsp {

/// The members of a provider's options, into an object that is open. The same whether they are announced in the answer
/// to `initialize` or registered later.
void write_provider_options(JsonWriter& out, Feature feature, const InitializeParams& client);

/// True where a feature is announced to this client at the start.
bool is_announced(Feature feature, const InitializeParams& client, const Settings& settings);

}  // namespace texbrdf::lsp

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lsp/json_writer.h"
#include "lsp/protocol.h"

namespace texbrdf::lsp {

struct SemanticTokensDeltaParams {
  std::string uri;
  std::string previous_result_id;
};
std::string read_params(nlohmann::json& params, SemanticTokensDeltaParams& out);

/// The members of SemanticTokensOptions: the legend, and which requests there are.
void write_semantic_tokens_options(JsonWriter& out);

}  // namespace texbrdf::lsp

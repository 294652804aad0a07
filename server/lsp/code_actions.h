#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lsp/json_writer.h"
#include "lsp/protocol.h"

namespace texbrdf::lsp {

struct CodeActionParams {
  std::string uri;
  Range range;
  std::vector<std::string> only;  ///< kinds that are asked for; empty: all
};
std::string read_params(nlohmann::json& params, CodeActionParams& out);

/// CodeActionOptions, into an object that is open.
void write_code_action_options(JsonWriter& out);

}  // namespace texbrdf::lsp

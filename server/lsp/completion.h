#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "features/completion.h"
#include "lsp/json_writer.h"

namespace texbrdf::lsp {

/// A proposal that is to be documented, as it was sent.
struct CompletionItemParams {
  std::vector<std::pair<std::string, std::string>> members;  ///< all of it: name, JSON
  std::string label;
  std::string uri;       ///< `data.uri`
  std::string kind;      ///< `data.kind`
  std::string function;  ///< `data.function`
};
std::string read_params(nlohmann::json& params, CompletionItemParams& out);

/// CompletionOptions, into an object that is open.
void write_completion_options(JsonWriter& out);

}  // namespace texbrdf::lsp

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lsp/protocol.h"

namespace texbrdf::lsp {

/// A lens that is to be given its command: what it was sent with.
struct CodeLensParams {
  Range range;
  std::string uri;   ///< `data.uri`
  std::string name;  ///< `data.name`
};
std::string read_params(nlohmann::json& params, CodeLensParams& out);

}  // namespace texbrdf::lsp

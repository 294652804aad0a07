#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace texbrdf::lsp {

struct DidChangeConfigurationParams {
  std::shared_ptr<nlohmann::json> settings;  ///< never nullptr
};
std::string read_params(nlohmann::json& params, DidChangeConfigurationParams& out);

}  // namespace texbrdf::lsp

#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lsp/json_writer.h"

namespace texbrdf::lsp {

struct DidChangeConfigurationParams {
  std::shared_ptr<nlohmann::json> settings;  ///< never nullptr
};
std::string read_params(nlohmann::json& params, DidChangeConfigurationParams& out);

/// Parameters of client/registerCapability for one method.
void write_registration(JsonWriter& out, const char* method, const std::function<void(JsonWriter&)>& write_options);

}  // namespace texbrdf::lsp

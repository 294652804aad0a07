#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lsp/protocol.h"

namespace texbrdf::lsp {

/// The parameters of what a browser asks the editor for (docs/lsp.md).

struct WantedChange {
  std::string uri;
  std::optional<int64_t> version;  ///< that the change is made for
  Range range;
  std::string text;
};

struct ApplyEditParams {
  std::vector<WantedChange> changes;
};

struct RevealParams {
  std::string uri;
  Range range;
};

struct ExecuteCommandParams {
  std::string command;
};

std::string read_params(nlohmann::json& params, ApplyEditParams& out);
std::string read_params(nlohmann::json& params, RevealParams& out);
std::string read_params(nlohmann::json& params, ExecuteCommandParams& out);

}  // namespace texbrdf::lsp

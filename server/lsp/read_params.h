#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lsp/protocol.h"

namespace texbrdf::lsp {

/// Read a message's `params` (strings are moved out of it). They return why the parameters are not what the method
/// asks for, empty where they are.
std::string read_params(nlohmann::json& params, NoParams& out);
std::string read_params(nlohmann::json& params, InitializeParams& out);
std::string read_params(nlohmann::json& params, DidOpenParams& out);
std::string read_params(nlohmann::json& params, DidChangeParams& out);
std::string read_params(nlohmann::json& params, DocumentParams& out);
std::string read_params(nlohmann::json& params, PositionParams& out);
std::string read_params(nlohmann::json& params, RangeParams& out);
std::string read_params(nlohmann::json& params, ReferenceParams& out);
std::string read_params(nlohmann::json& params, PullParams& out);
std::string read_params(nlohmann::json& params, RenameParams& out);
std::string read_params(nlohmann::json& params, WorkspaceFoldersParams& out);

}  // namespace texbrdf::lsp

#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "viewing/viewer.h"

namespace texbrdf::lsp {

/// The parameters of the methods about previews of scenes (docs/lsp.md).

/// What a client says of how a scene is shown; the rest stays as it is.
struct SceneChange {
  std::optional<int64_t> width, height;  ///< pixels
  std::optional<std::string> view;       ///< "normals"
  std::optional<double> exposure, gamma;
};

struct OpenSceneParams {
  std::string uri;
  SceneChange change;
};

struct UpdateSceneParams {
  int64_t preview = 0;
  SceneChange change;
};

struct SceneInputParams {
  int64_t preview = 0;
  viewing::Input input;
};

std::string read_params(nlohmann::json& params, OpenSceneParams& out);
std::string read_params(nlohmann::json& params, UpdateSceneParams& out);
std::string read_params(nlohmann::json& params, SceneInputParams& out);

}  // namespace texbrdf::lsp

#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lsp/object_params.h"
#include "plots/request.h"
#include "render/sphere.h"

namespace texbrdf::lsp {

/// The parameters of the methods `texbrdf/…` (docs/lsp.md).

/// What a client says of a view; the rest stays as it is.
struct ViewChange {
  std::optional<int64_t> width, height;  ///< pixels
  std::optional<std::string> root;
  std::optional<double> theta, phi;  ///< degrees
  std::optional<double> zoom, exposure, gamma;
  std::optional<bool> cosine;
  ObjectChange object;
};

struct OpenPreviewParams {
  std::string uri;
  ViewChange view;
};

struct UpdatePreviewParams {
  int64_t preview = 0;
  ViewChange view;
};

struct PreviewParams {
  int64_t preview = 0;
};

struct SetParameterParams {
  int64_t preview = 0;
  std::string name;
  std::optional<std::vector<double>> value;  ///< nothing: the document's
};

struct ModelParams {
  std::string uri;
  std::string root;  ///< empty: the document's
};

struct ParameterEditParams {
  std::string uri;
  std::string name;
  std::vector<double> value;
};

struct EmitParams {
  std::string uri;
  std::string root;
  std::string target;
};

struct ProbeParams {
  int64_t preview = 0;
  render::PicturePlace place;
  std::string definition;  ///< canonical; empty: the BRDF alone
};

struct PlotParams {
  int64_t preview = 0;
  plots::View view = plots::View::ThetaO;
  std::optional<double> theta_h, theta_d, phi_d;  ///< degrees
};

std::string read_params(nlohmann::json& params, OpenPreviewParams& out);
std::string read_params(nlohmann::json& params, UpdatePreviewParams& out);
std::string read_params(nlohmann::json& params, PreviewParams& out);
std::string read_params(nlohmann::json& params, SetParameterParams& out);
std::string read_params(nlohmann::json& params, ModelParams& out);
std::string read_params(nlohmann::json& params, ParameterEditParams& out);
std::string read_params(nlohmann::json& params, EmitParams& out);
std::string read_params(nlohmann::json& params, ProbeParams& out);
std::string read_params(nlohmann::json& params, PlotParams& out);

}  // namespace texbrdf::lsp

#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "preview/object_look.h"

namespace texbrdf::lsp {

class ParamsReader;

/// What a client says of the object of a preview and its light; the rest stays as it is.
struct ObjectChange {
  std::optional<std::string> shape, light;
  std::optional<double> yaw, pitch, elevation, azimuth, turbidity;
  std::optional<int64_t> samples;
};

/// The member `object` of the parameters, if there is one.
ObjectChange read_object(ParamsReader& reader, nlohmann::json* params);

/// Why it cannot be, or nothing. Files are named from the folder of the document, and are below a folder that the
/// editor has open.
std::optional<std::string> change_object(const ObjectChange& change, const std::string& document_uri,
                                         const std::function<bool(const std::string&)>& may_read,
                                         preview::ObjectLook& look);

}  // namespace texbrdf::lsp

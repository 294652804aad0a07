#pragma once

#include <string>
#include <string_view>

namespace texbrdf::cli {

/// A path as a URI reference: all but unreserved characters and `/` percent-encoded; `file://` before an absolute one.
std::string uri_of_path(std::string_view path);

}  // namespace texbrdf::cli

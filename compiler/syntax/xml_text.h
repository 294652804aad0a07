#pragma once

#include <string>
#include <string_view>

namespace texbrdf {

/// Text as content of an XML element; what XML cannot hold becomes U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace texbrdf

#include "lsp/uri.h"

#include <charconv>

namespace texbrdf::lsp {
namespace {

constexpr std::string_view kFileScheme = "file://";

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      decoded += static_cast<char>(byte);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

}  // namespace

std::string shown_path(std::string_view uri) {
  if (!uri.starts_with(kFileScheme)) return std::string(uri);
  return percent_decoded(uri.substr(kFileScheme.size()));
}

}  // namespace texbrdf::lsp

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

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kPlain = "/-._~";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          kPlain.find(c) != std::string_view::npos;
    if (is_plain) {
      uri += c;
    } else {
      uri += '%';
      uri += kDigits[byte >> 4U];
      uri += kDigits[byte & 15U];
    }
  }
  return uri;
}

std::string file_uri(std::string_view path) {
  return std::string(kFileScheme).append(percent_encoded(path));
}

}  // namespace texbrdf::lsp

#pragma once

#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// The path of a `file:` URI, percent-decoded, to be shown to people; any other URI as it is. Documents are told apart
/// by their URIs as the client writes them, never by this.
std::string shown_path(std::string_view uri);

/// A path as it stands in a URI: all but `/` and RFC 3986's unreserved characters as `%XX`.
std::string percent_encoded(std::string_view path);

/// The `file:` URI of an absolute path.
std::string file_uri(std::string_view path);

}  // namespace texbrdf::lsp

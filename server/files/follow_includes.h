#pragma once

#include <string>
#include <variant>
#include <vector>

#include "analysis/document.h"
#include "files/file_source.h"

namespace texbrdf::files {

/// A path, or why there is none.
using ResolvedInclude = std::variant<std::string, Code>;

/// The file that the command means, where it stands in `file` and `root` is the first file of the project.
ResolvedInclude resolve_include(const IncludeTarget& target, std::string_view root, std::string_view file,
                                const FileSource& source);

/// Makes the files of the document those that its first file includes, directly or by others, each once, in the order
/// of their inclusion. `paths` has the path of each. What cannot be followed is told to the document; false where there
/// is any.
bool follow_includes(Document& document, std::vector<std::string>& paths, FileSource& source);

}  // namespace texbrdf::files

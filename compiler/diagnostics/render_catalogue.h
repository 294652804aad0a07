#pragma once

#include <string>

namespace texbrdf {

/// The Markdown page of all diagnostics: a section per stage, an anchor per code (`#E2001`).
std::string render_catalogue();

}  // namespace texbrdf

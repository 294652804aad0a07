#pragma once

#include <span>
#include <string>

#include "cli/checked_file.h"

namespace texbrdf::cli {

/// SARIF 2.1.0, with the catalogue as its rules.
std::string diagnostics_sarif(std::span<const CheckedFile> files);

}  // namespace texbrdf::cli

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "source/result.h"

namespace texbrdf::cli {

/// All bytes of a file, or of standard input for "-". Fails on directories and on more than SourceText::kMaxBytes.
Result<std::string> read_input(const std::string& path);

/// Writes a whole result to a file, or to standard output for "-". A regular file is replaced at once, so that nobody
/// sees half of it and a failure leaves the old one.
std::optional<Failure> write_output(const std::string& path, std::string_view bytes);

/// How a path is named in messages: "standard input" for "-".
std::string input_name(const std::string& path);

}  // namespace texbrdf::cli

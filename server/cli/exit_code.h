#pragma once

#include <cstdint>

namespace texbrdf::cli {

/// What the program exits with; scripts rely on the numbers.
enum class ExitCode : uint8_t {
  Fine = 0,
  DocumentHasErrors = 1,
  BadUsage = 2,  ///< also a file that cannot be read or written
  NoRenderer = 3,
  InternalFault = 70,  ///< a broken invariant of ours (EX_SOFTWARE)
};

}  // namespace texbrdf::cli

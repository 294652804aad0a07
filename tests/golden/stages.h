#pragma once

#include <span>
#include <string>
#include <string_view>

#include "analysis/snapshot.h"

namespace texbrdf::test {

/// A stage of the compiler whose output is a golden file: one line each in stages.cpp.
struct Stage {
  std::string_view name;  ///< and the golden file's extension
  std::string (*output)(const Snapshot& snapshot);
};

std::span<const Stage> stages();
const Stage* find_stage(std::string_view name);

}  // namespace texbrdf::test

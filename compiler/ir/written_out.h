#pragma once

#include <cstdint>

#include "ir/program.h"

namespace texbrdf::ir {

/// How many values a program has when every call is written out: what flattening goes through at most. No further
/// counted than `limit` + 1.
uint64_t written_out(const Program& program, uint64_t limit);

}  // namespace texbrdf::ir

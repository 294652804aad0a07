#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// By how much the integrals that the root needs may be wrong: its values at a few directions are held against those
/// with half as many points. The largest relative difference where it is worth telling; nothing where it is not, or
/// cannot be computed within a few million steps, or when it is stopped. Deterministic.
std::optional<double> integral_error(const Snapshot& snapshot, std::string_view root, const std::stop_token& stop = {});

}  // namespace texbrdf::features

#pragma once

// Included by the kernels: constants only, see kernels/kernel.h.

namespace texbrdf::eval {

/// How far beyond ±1 arccos and arcsin accept an argument, as if it were ±1: what rounding does to a dot product.
inline constexpr double kArcTolerance = 1e-6;
/// The most iterations of one Sum or Product; a longer range gives NaN. GPU drivers cut loops off there (llvmpipe does
/// so silently), so a longer one could not be drawn truly.
inline constexpr int kMaxIterations = 65'535;
/// Bounds beyond ± this give NaN: up to here single precision counts by ones.
inline constexpr double kMaxBound = 16'777'216;
/// The most iterations of all reductions together in one evaluation (of one geometry, or of one batch): reductions
/// inside reductions end there, with NaN, instead of running for days.
inline constexpr unsigned kMaxTotalIterations = 1u << 20;

}  // namespace texbrdf::eval

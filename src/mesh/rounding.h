#pragma once

/// How far apart computed numbers may be that should be equal, as a part of what they are computed
/// from: the longer the computation, the farther. A comparison takes the one for its numbers.
namespace karcher {

/// A few operations on doubles, each of which rounds by 1.1e-16.
inline constexpr double kStepRounding = 1e-15;
/// A computation in one face or two, such as the place where a line crosses an edge.
inline constexpr double kLocalRounding = 1e-12;
/// A chain of such computations: lengths of paths, angles around vertices, sums over many points.
inline constexpr double kChainRounding = 1e-9;
/// Coordinates of a file or a ray that are in single precision.
inline constexpr double kFloatRounding = 1e-6;

}  // namespace karcher

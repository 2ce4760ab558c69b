#pragma once

/// The largest differences between computed numbers that should be equal, relative to their inputs.
/// The longer the computation, the larger the difference. A comparison uses the constant that fits
/// the computation of its numbers.
namespace karcher {

/// A few operations on doubles, each of which rounds by 1.1e-16.
inline constexpr double kStepRounding = 1e-15;
/// A computation in one face or two, such as the place where a line crosses an edge.
inline constexpr double kLocalRounding = 1e-12;
/// A chain of such computations: lengths of paths, angles around vertices, sums over many points.
inline constexpr double kChainRounding = 1e-9;
/// Coordinates in single precision, of a file or a ray.
inline constexpr double kFloatRounding = 1e-6;

}  // namespace karcher

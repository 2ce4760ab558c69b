#pragma once

#include "curves/curve.h"
#include "generators/curve_shapes.h"

/// Helpers that several tests of curves share.
namespace karcher {

inline constexpr FieldOptions kFast{Method::kKarcher, Solver::kFast, 6};
inline constexpr FieldOptions kExact{Method::kKarcher, Solver::kExact, 6};
inline constexpr FieldOptions kPaperExact{Method::kPaper, Solver::kExact, 6};

/// The options of a curve with this number of levels.
CurveOptions levelsOptions(const CurveShape& shape, int samples, int levels, FieldOptions field);

/// The surface points nearest to places in space.
Array<SurfacePoint> pointsNear(const TriangleMesh& mesh, const Array<Vec3>& places);

/// Places of the unit square, away from its sides; their polygon turns left and right.
inline const Array<Vec3> kPlaces{{0.3, 0.3, 0},  {0.45, 0.68, 0}, {0.62, 0.41, 0},
                                 {0.7, 0.65, 0}, {0.52, 0.3, 0},  {0.38, 0.52, 0}};

/// The weighted average of numbers.
double weightedSum(const Array<double>& weights, const Array<double>& values);

}  // namespace karcher

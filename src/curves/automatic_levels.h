#pragma once

#include "curves/spec/curve_shape.h"
#include "intrinsic/surface_path.h"

namespace karcher {

/// A piece of a curve is a safe center of mass where its points reach no more total absolute
/// curvature than this, radians: the square of a cubic's leg times the absolute curvature per area.
/// By the study of steadiness, at twice as much curves begin to turn more than their limit, and at
/// four times as much some shiver.
inline constexpr double kSafeCurvature = 0.5;

/// The fewest levels at which the pieces of a curve are safe centers of mass: 0 on smooth surfaces
/// with near points, more where points are far or the surface is rough. The curvature per area is
/// that of the faces that the legs cross, by the angle defects of their vertices. The legs are
/// those of the whole control polygon. Depends on nothing else.
int automaticLevels(const Geometry& geometry, const CurveShape& shape, int points,
                    const Array<SurfacePath>& legs);

/// So many levels that legs are twice as long as edges, as far as the work allows, and at least
/// two: what is then averaged is the subdivision curve but for a small part of an edge.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

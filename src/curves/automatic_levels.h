#pragma once

#include "curves/polygon/levels.h"

namespace karcher {

/// Radians: a piece of a curve is a safe center of mass if its points reach no more total absolute
/// curvature than this, which is the square of a cubic's leg times the absolute curvature per area.
/// By the study of steadiness, curves begin to turn more than their limit at twice as much, and
/// some shiver at four times as much.
inline constexpr double kSafeCurvature = 0.5;

/// Radians: a piece of one n-th of a segment may pass n times as much curvature. Beside the
/// subdivision curve a segment is moved, as a part of its length, by about a fortieth of that or
/// less: half a percent.
inline constexpr double kSafeShare = 0.2;

/// Mean edges: a curve is refined until its legs are no longer than this. The fields of a piece's
/// points hold about the square of its legs, and there are twice as many pieces a level, so each
/// level down to here spares work; below, pieces cost more than their fields. At level 0 fields
/// need a wavefront, and take longest. Where pieces are safe anyway, this moves the curve by a
/// thousandth of its length at most.
inline constexpr double kSmallLeg = 3;

/// How many levels a curve takes: the fewest at which its pieces are safe centers of mass and have
/// small legs. None on smooth surfaces with near points. The curvature per area is estimated from
/// the angle defects at the faces that the legs cross. `legs` are those of the whole control
/// polygon. The result depends on these arguments alone.
int automaticLevels(const Geometry& geometry, const CurveShape& shape, int points,
                    const Array<SurfacePath>& legs);

/// Whether a polygon that was refined `levels` >= 1 times should be once more: a leg of it passes
/// more curvature than is safe. The legs of the control polygon tell only of where they lie: where
/// they go round the rim of an ear, the curve goes over it.
bool takesMoreLevels(const Geometry& geometry, const CurveShape& shape, int points,
                     const RefinedPolygon& refined, int levels);

/// As many levels as make legs twice as long as edges, if the work allows that, and at least two.
/// The averages then lie within a small fraction of an edge of the subdivision curve.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

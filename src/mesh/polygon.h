#pragma once

#include "mesh/types.h"

namespace karcher {

/// The most corners of a polygon that `cutPolygon` cuts. The time grows with the square of their
/// number.
inline constexpr int kMostPolygonCorners = 10'000;

/// Cuts a polygon into triangles that keep its orientation. `corners` holds the positions of its
/// corners in order, not necessarily in one plane; the triangles' indices count them from 0. Always
/// clips the ear with the shortest diagonal (G. Meisters, "Polygons Have Ears", 1975), seen along
/// the polygon's mean normal. Returns corners - 2 triangles. The result is empty if no ear remains
/// because the polygon crosses itself or has no area, and for fewer than 3 or more than
/// kMostPolygonCorners corners.
Array<Triangle> cutPolygon(const Array<Vec3>& corners);

}  // namespace karcher

#pragma once

#include "mesh/types.h"

namespace karcher {

/// The largest number of corners of a polygon that `cutPolygon` cuts. The time grows with the
/// square of the number of corners.
inline constexpr int kMostPolygonCorners = 10'000;

/// Cuts a polygon into triangles that keep its orientation. `corners` holds the positions of its
/// corners in order, not necessarily in one plane; the triangles have indices into `corners`. The
/// function projects the polygon along its mean normal, and always clips the ear with the shortest
/// diagonal (G. Meisters, "Polygons Have Ears", 1975). Returns corners - 2 triangles. The result is
/// empty for fewer than 3 or more than kMostPolygonCorners corners. It is also empty if no ear
/// remains because the polygon crosses itself or has no area.
Array<Triangle> cutPolygon(const Array<Vec3>& corners);

}  // namespace karcher

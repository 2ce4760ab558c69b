#pragma once

#include "mesh/types.h"

namespace karcher {

/// The most corners of a polygon that is cut. The time grows with the square of their number.
inline constexpr int kMostPolygonCorners = 10'000;

/// Cuts a polygon into triangles that keep its orientation. `corners` holds the positions of its
/// corners in order, not necessarily in one plane, and the triangles' indices count them from 0.
/// Always clips the ear with the shortest diagonal (G. Meisters, "Polygons Have Ears", 1975), seen
/// along the polygon's mean normal. Returns corners - 2 triangles, or none if no ear is left
/// because the polygon crosses itself or has no area.
Array<Triangle> cutPolygon(const Array<Vec3>& corners);

}  // namespace karcher

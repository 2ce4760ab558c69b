#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

/// Tessellations of a piece of the plane z = 0: the unit square, or for kStretchedSheared its image
/// under the shear x += y.
enum class PlaneTessellation {
  kRandomDelaunay,    ///< the Delaunay triangulation of random points
  kJitteredDelaunay,  ///< the Delaunay triangulation of a jittered grid
  kRegularGrid,       ///< squares cut by parallel diagonals
  kStretched,         ///< the Delaunay triangulation of a jittered grid, stretched 20:1 along x
  kStretchedSheared,  ///< the same, sheared
  kStretchedRandom,   ///< a jittered grid of cells 20:1, cut by random diagonals
};

inline constexpr PlaneTessellation kPlaneTessellations[] = {
    PlaneTessellation::kRandomDelaunay,   PlaneTessellation::kJitteredDelaunay,
    PlaneTessellation::kRegularGrid,      PlaneTessellation::kStretched,
    PlaneTessellation::kStretchedSheared, PlaneTessellation::kStretchedRandom};

/// The name in tables, such as "Delaunay of random points".
const char* tessellationName(PlaneTessellation tessellation);

/// About `triangles` triangles (within a few per cent from 1,000 on), facing +z.
TriangleSoup tessellatedPlane(PlaneTessellation tessellation, int triangles, uint64_t seed);

}  // namespace karcher

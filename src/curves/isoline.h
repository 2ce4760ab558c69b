#pragma once

#include "intrinsic/geometry.h"

/// Isolines: lines of points at one distance from a source. Studies compare circles with them.
namespace karcher {

/// One line of an isoline or of an offset. Consecutive points share a face. Where the line crosses
/// an edge, it may have two points, one in each of the edge's faces.
struct Isoline {
  Array<SurfacePoint> points;
  /// whether the last point is the first one; if not, both ends of an isoline lie on the boundary
  bool closed = true;
  double length = 0;
};

/// Throws Error kBadArgument for a distance that is not positive and finite.
void checkIsolineRadius(double radius);

/// The isolines of a distance that is linear in each triangle. `values` are the distances of the
/// vertices (kInfinity or any number). The lines are straight from edge to edge and have smaller
/// values on their left. Throws Error kBadArgument (level not positive and finite).
Array<Isoline> linearIsolines(const TriangleMesh& mesh, const Array<double>& values, double level);

/// The exact isolines at the distance `radius` from the source. In each face they consist of arcs
/// about the source's images (source_images.h), without the points to which another path is
/// shorter. Points divide each arc so that its chords stay within `tolerance` mean edges of it. The
/// length of a line is the sum of the lengths of its arcs. Throws Error: kBadArgument (radius or
/// tolerance not positive and finite).
Array<Isoline> exactIsolines(const Geometry& geometry, const SurfacePoint& source, double radius,
                             double tolerance = 1e-3);

}  // namespace karcher

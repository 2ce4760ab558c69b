#pragma once

#include "mesh/surface_point.h"

/// A path on the surface: the one type for all of them, be they shortest, straightest, of a curve
/// or of a caller.
namespace karcher {

struct SurfacePath {
  /// At least one; consecutive points share a face.
  Array<SurfacePoint> points;
  /// Per point the length of the path up to it, from 0.
  Array<double> lengths;

  double length() const { return lengths.back(); }
  const SurfacePoint& start() const { return points.front(); }
  const SurfacePoint& end() const { return points.back(); }
};

/// Sets the lengths of a path by its points; with this, a path that is written anew spares the
/// allocations.
void measure(const TriangleMesh& mesh, SurfacePath& path);

/// Appends a point that shares a face with the last one, if it is another.
void appendPoint(const TriangleMesh& mesh, const SurfacePoint& point, SurfacePath& path);

/// The path through points of which consecutive ones share a face.
SurfacePath pathThrough(const TriangleMesh& mesh, Array<SurfacePoint> points);

/// Whether two points are the same, seen from whatever faces.
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// The point at the part s of the straight line from a to b, in a face that holds both.
SurfacePoint pointBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b,
                          double s);

/// The number of a path's piece (between points k and k + 1) at a length from its start, which is
/// clamped to the path; by the path's lengths, of two points at least.
int pieceAt(const Array<double>& lengths, double length);

/// The point at a length from the start, which is clamped to the path.
SurfacePoint pointAlong(const TriangleMesh& mesh, const SurfacePath& path, double length);

/// Appends to `out` the part of a path between two lengths from its start; backwards where
/// `from` > `to`. A first point that is `out`'s last is not repeated.
void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                SurfacePath& out);

/// The same without its lengths, for a path that is to be straightened.
void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                Array<SurfacePoint>& out);

void reverse(SurfacePath& path);
SurfacePath reversed(SurfacePath path);

}  // namespace karcher

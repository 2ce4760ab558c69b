#pragma once

#include "mesh/surface_point.h"

/// Paths on the surface: one type for shortest paths, straightest paths, parts of curves and
/// callers' own paths.
namespace karcher {

struct SurfacePath {
  /// The points, at least one. Consecutive points share a face.
  Array<SurfacePoint> points;
  /// The length of the path up to each point, from 0.
  Array<double> lengths;

  double length() const { return lengths.back(); }
  const SurfacePoint& start() const { return points.front(); }
  const SurfacePoint& end() const { return points.back(); }
};

/// Computes the lengths of a path from its points.
void measure(const TriangleMesh& mesh, SurfacePath& path);

/// Appends a point that shares a face with the last one, unless it is the same place.
void appendPoint(const TriangleMesh& mesh, const SurfacePoint& point, SurfacePath& path);

/// The path through points. Consecutive ones must share a face.
SurfacePath pathThrough(const TriangleMesh& mesh, Array<SurfacePoint> points);

/// Whether two points are the same place. Their faces may differ.
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// The point at the ratio s of the way from a to b, on the straight line in a face that holds both.
/// If no face holds both, it is a for s < 1/2, and otherwise b.
SurfacePoint pointBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b,
                          double s);

/// The piece of a path at a length from the path's start: the index k of the piece between points k
/// and k + 1. Lengths beyond an end of the path give the piece at this end. `lengths` are those of
/// the path, which must have at least two points.
int pieceAt(const Array<double>& lengths, double length);

/// The point of a path at a length from the path's start. Lengths beyond an end give this end.
SurfacePoint pointAlong(const TriangleMesh& mesh, const SurfacePath& path, double length);

/// Appends to `out` the part of a path between two lengths from its start, backwards if `from` >
/// `to`. If the first point equals the last of `out`, it is not repeated.
void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                SurfacePath& out);

/// The same part as points without lengths, for a path that the caller then straightens.
void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                Array<SurfacePoint>& out);

void reverse(SurfacePath& path);
SurfacePath reversed(SurfacePath path);

}  // namespace karcher

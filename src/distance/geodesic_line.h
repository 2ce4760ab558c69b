#pragma once

#include "intrinsic/along_path.h"

/// A geodesic as a polyline on the surface, to be cut.
namespace karcher {

struct GeodesicLine {
  /// At least two; consecutive points share a face.
  Array<SurfacePoint> points;
  /// Per point the length of the line up to it.
  Array<double> lengths;

  double length() const { return lengths.back(); }
};

/// A locally shortest path (local_path.h), wherever the points lie: in a small part of the time of
/// the shortest path of all, than which it is seldom longer by more than 1 %.
/// Throws Error kUnreachable where the points lie on different components.
GeodesicLine geodesicLine(const Geometry& geometry, const SurfacePoint& from,
                          const SurfacePoint& to);

/// A line cut in the middle of its length.
struct LineHalves {
  GeodesicLine first;
  GeodesicLine second;
};
LineHalves halvesOf(const TriangleMesh& mesh, const GeodesicLine& line);

/// The center of mass of two points with weights 1 - s and s: the point at the part s in [0, 1] of
/// a shortest path from a to b. Throws Error kUnreachable.
SurfacePoint averageOf(const Geometry& geometry, const SurfacePoint& a, const SurfacePoint& b,
                       double s);

}  // namespace karcher

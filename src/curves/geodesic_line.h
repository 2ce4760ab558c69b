#pragma once

#include "curves/along_path.h"

/// A shortest path as a polyline on the surface, to be cut.
namespace karcher {

struct GeodesicLine {
  /// At least two; consecutive points share a face.
  Array<SurfacePoint> points;
  /// Per point the length of the line up to it.
  Array<double> lengths;

  double length() const { return lengths.back(); }
};

/// Throws Error kUnreachable where the points lie on different components.
GeodesicLine shortestLine(const Geometry& geometry, const SurfacePoint& from,
                          const SurfacePoint& to);

/// A line cut in the middle of its length.
struct LineHalves {
  GeodesicLine first;
  GeodesicLine second;
};
LineHalves halvesOf(const TriangleMesh& mesh, const GeodesicLine& line);

}  // namespace karcher

#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Averages on the legs of a control polygon, and the paths that join them.
namespace karcher {

/// A control point with its weight. The weight of an average of two points is the sum of their
/// weights.
struct WeightedPoint {
  SurfacePoint point;
  double weight = 1;
};

/// The points of a piece and the legs between them.
struct LeggedPolygon {
  Array<WeightedPoint> points;
  Array<SurfacePath> legs;  ///< the legs, one fewer than points
};

/// The average of both ends of a leg, and the length of the leg from its start to the average.
struct LegAverage {
  WeightedPoint point;
  double at = 0;
};

/// The average of a leg's ends with the weights `from` and `to`, both positive.
inline LegAverage averageOn(const TriangleMesh& mesh, const SurfacePath& path, double from,
                            double to) {
  const double at = path.length() * (to / (from + to));
  return {{pointAlong(mesh, path, at), from + to}, at};
}

/// Joins consecutive paths into one, which the caller then straightens. Writes to `path`.
class Chain {
 public:
  Chain(const TriangleMesh& mesh, SurfacePath& path) : mesh_(mesh), points_(path.points) {
    points_.clear();
    // Straightening leaves a path of one point as it is, so its length is set here.
    path.lengths.assign(1, 0.0);
  }
  /// Appends the part of a path between two lengths, backwards if from > to.
  void append(const SurfacePath& next, double from, double to) {
    appendPart(mesh_, next, from, to, points_);
  }
  void append(const SurfacePath& next) { append(next, 0, next.length()); }
  void appendReversed(const SurfacePath& next) { append(next, next.length(), 0); }

 private:
  const TriangleMesh& mesh_;
  Array<SurfacePoint>& points_;
};

/// Writes the part of a path between two lengths, backwards if from > to.
inline void takePart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                     SurfacePath& part) {
  part.points.clear();
  part.lengths.clear();
  appendPart(mesh, path, from, to, part);
}

}  // namespace karcher

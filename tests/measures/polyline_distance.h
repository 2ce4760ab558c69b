#pragma once

#include "measures/box_tree.h"

namespace karcher {

/// A polyline in space of at least two points, prepared for queries of distances.
class MeasuredPolyline {
 public:
  explicit MeasuredPolyline(Array<Vec3> points);

  const Array<Vec3>& points() const { return points_; }
  /// The piece nearest to q, from point `item` to the next; `known` is a piece that may be near.
  BoxTree::Nearest nearest(const Vec3& q, int known = 0) const;

 private:
  double squaredDistance(int piece, const Vec3& q) const;

  Array<Vec3> points_;
  BoxTree tree_;
};

/// The largest distance of a point of either polyline from the other, reduced by at most
/// `tolerance`.
double hausdorffDistance(const MeasuredPolyline& a, const MeasuredPolyline& b, double tolerance);

}  // namespace karcher

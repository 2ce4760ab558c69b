#pragma once

#include "distance/arrival.h"
#include "distance/window.h"
#include "intrinsic/geometry.h"

namespace karcher {

/// The end of the shortest path to a target inside a face or on an edge.
struct TargetArrival {
  Arrival arrival;
  int face = -1;                ///< the face through which the path arrives
  Vec2 direction = Vec2(1, 0);  ///< a unit vector towards the source, in the frame of that face
};

/// A point of a face or an edge. Windows that pass it update its distance.
class WatchedTarget {
 public:
  /// The geometry must outlive the object.
  explicit WatchedTarget(const Geometry& geometry) : geometry_(geometry) {}

  /// Stops watching a point.
  void clear();
  /// Watches a point. Throws Error kBadArgument for a point at a vertex.
  void set(const SurfacePoint& point);

  bool liesIn(int face) const { return face == faces_[0] || face == faces_[1]; }
  const TargetArrival& best() const { return best_; }

  /// Updates the arrival by the straight path from `vertex`, the tail of half-edge h. `distance` is
  /// the distance of this vertex.
  void arriveFromCorner(int h, int vertex, double distance);
  /// Updates the arrival by the path through a window of half-edge h.
  void arriveThrough(int h, const Window& window);

 private:
  Vec2 pointOver(int h) const;
  void arrive(int h, const Arrival& arrival, const Vec2& toSource);

  const Geometry& geometry_;
  SurfacePoint point_;
  int faces_[2] = {-1, -1};
  TargetArrival best_;
  int via_ = -1;  ///< the half-edge through which the path arrived
};

}  // namespace karcher

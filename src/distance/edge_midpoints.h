#pragma once

#include "distance/arrival.h"
#include "distance/distance_solver.h"
#include "distance/paged_array.h"
#include "distance/window.h"

namespace karcher {

/// Exact arrivals at the midpoints of edges. Stores for each half-edge the arrived window that
/// gives the least distance at the midpoint.
class EdgeMidpoints {
 public:
  /// The geometry must outlive the object.
  explicit EdgeMidpoints(const Geometry& geometry)
      : geometry_(geometry), records_(geometry.mesh->faceCount()) {}

  void clear() { records_.clear(); }

  /// Takes a window that arrived at half-edge h while all distances below `reached` were final.
  void take(int h, const Window& window, double reached) {
    const double length = geometry_.edgeLength[h];
    const double middle = length / 2;
    const double tolerance = kSeenTolerance * length;
    if (window.begin > middle + tolerance || window.end < middle - tolerance) return;
    const double distance = distanceAt(window, middle);
    Record& record = records_.touch(faceOf(h)).edge[cornerOf(h)];
    const bool isBetter = isTie(distance, record.distance) ? window.sourceX < record.sourceX
                                                           : distance < record.distance;
    if (!isBetter || record.distance <= reached) return;
    record = {distance, window.sourceX, window.depth};
  }

  /// The arrival at the midpoint of half-edge h, from the source and the distances at the edge's
  /// ends.
  MidpointArrival arrival(int h, const SurfacePoint& source, double tailDistance,
                          double headDistance) const;

 private:
  struct Record {
    double distance = kInfinity;
    double sourceX = 0;
    double depth = 0;
  };
  struct FaceRecords {
    Record edge[3];
  };

  const Geometry& geometry_;
  PagedArray<FaceRecords, 7> records_;
};

}  // namespace karcher

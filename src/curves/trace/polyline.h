#pragma once

#include "curves/trace/joined_path.h"

namespace karcher {

/// A segment of a geodesic polyline.
struct PolylineSegment {
  Array<CurveSample> samples;
  JoinedPath path;
};

/// The shortest path between two points, with samples at the parts t of its length: the centers of
/// mass of the two with weights 1 - t and t, exact and wherever they lie.
PolylineSegment traceShortestPath(Surface& surface, const SurfacePoint& from,
                                  const SurfacePoint& to, int samples);

}  // namespace karcher

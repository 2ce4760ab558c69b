#include "distance/edge_midpoints.h"

namespace karcher {

MidpointArrival EdgeMidpoints::arrival(int h, const SurfacePoint& source, double tailDistance,
                                       double headDistance) const {
  const TriangleMesh& mesh = *geometry_.mesh;
  const double middle = geometry_.edgeLength[h] / 2;
  const int t = mesh.twin[h];
  // The source itself may lie on the edge.
  const PointLocation place = locate(mesh, source);
  if (place.simplex == Simplex::kEdge && (place.halfedge == h || place.halfedge == t)) {
    const double part = source.bary[cornerOf(next(place.halfedge))];
    const double along = (place.halfedge == h ? 2 * part - 1 : 1 - 2 * part) * middle;
    return {std::abs(along), Vec2(along < 0 ? -1 : 1, 0)};
  }
  MidpointArrival best;
  const auto isShorter = [&](double distance) {
    return distance < best.distance && !isTie(distance, best.distance);
  };
  for (const int side : {h, t}) {
    const FaceRecords* records = side < 0 ? nullptr : records_.find(faceOf(side));
    if (records == nullptr) continue;
    const Record& record = records->edge[cornerOf(side)];
    if (!isShorter(record.distance)) continue;
    const Vec2 toSource = Vec2(record.sourceX - middle, -record.depth).normalized();
    best = {record.distance, side == h ? toSource : Vec2(-toSource)};
  }
  // The path may also run along the edge, from a vertex at which paths turn.
  const double overTail = bentLength(tailDistance + middle);
  if (isShorter(overTail)) best = {overTail, Vec2(-1, 0)};
  const double overHead = bentLength(headDistance + middle);
  if (isShorter(overHead)) best = {overHead, Vec2(1, 0)};
  return best;
}

}  // namespace karcher

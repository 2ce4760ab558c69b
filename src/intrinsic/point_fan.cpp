#include "intrinsic/point_fan.h"

#include <cmath>

#include "intrinsic/angles.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"

namespace karcher {

PointFan fanAt(const Geometry& geometry, const SurfacePoint& point) {
  const TriangleMesh& mesh = *geometry.mesh;
  PointFan fan;
  const PointLocation location = locate(mesh, point);
  const auto add = [&](int face, double begin, double width, double inFrame) {
    const Vec2 middle = pointInFace(geometry, inFace(mesh, point, face));
    fan.corners.push_back({face, begin, begin + width, inFrame, middle});
    fan.total = begin + width;
  };
  if (location.simplex == Simplex::kFace) {
    add(point.face, 0, 2 * kPi, 0);
  } else if (location.simplex == Simplex::kEdge) {
    const int h = location.halfedge;
    add(faceOf(h), 0, kPi, angleOf(halfedgeInFace(geometry, h)));
    const int t = mesh.twin[h];
    if (t >= 0) add(faceOf(t), kPi, kPi, angleOf(halfedgeInFace(geometry, t)));
    fan.isRound = t >= 0;
  } else {
    for (const int h : outgoingHalfedges(mesh, location.vertex)) {
      add(faceOf(h), geometry.cumulatedAngle[h], geometry.cornerAngle[h],
          angleOf(halfedgeInFace(geometry, h)));
    }
    fan.isRound = !mesh.onBoundary[location.vertex];
  }
  return fan;
}

double angleTowards(const Geometry& geometry, const PointFan& fan, const SurfacePoint& point,
                    const SurfacePoint& towards) {
  const TriangleMesh& mesh = *geometry.mesh;
  const int face = commonFace(mesh, point, towards);
  for (const PointFan::Corner& corner : fan.corners) {
    if (corner.face != face) continue;
    const Vec2 way = stepInFace(geometry, face, point, towards);
    const double width = corner.end - corner.begin;
    double angle = withoutTurns(angleOf(way) - corner.inFrame - width / 2);
    angle += width / 2;
    return corner.begin + angle;
  }
  throw Error(ErrorCode::kBadArgument, "a path has a point in no face");
}

}  // namespace karcher

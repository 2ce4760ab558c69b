#include "intrinsic/strip_path.h"

#include "intrinsic/tightening.h"

namespace karcher {

double Tightening::append(Array<SurfacePoint>& out) const {
  double length = 0;
  int lastVertex = fromLocation_.vertex;
  const auto appendVertex = [&](int h) {
    if (mesh_.tail(h) == lastVertex) return;
    lastVertex = mesh_.tail(h);
    out.push_back(edgePoint(h, 0));
  };
  Vec2 at = start_;
  int portal = 0;
  for (int leg = 0; leg <= bends_.count(); ++leg) {
    const bool atEnd = leg == bends_.count();
    const Vec2 to = atEnd ? end_ : positionOf(bends_[leg]);
    const Run run = atEnd ? Run{crossingCount(), crossingCount()} : runAround(bends_[leg]);
    const Vec2 along = to - at;
    for (; portal < run.first; ++portal) {
      const int h = crossing(portal);
      const Vec2& right = workspace_.portals[portal].right;
      const Vec2 across = workspace_.portals[portal].left - right;
      const double width = cross(along, across);
      const double s = width > 0 ? cross(along, at - right) / width : 0;
      if (s <= kLocalRounding) {
        appendVertex(h);
      } else if (s >= 1 - kLocalRounding) {
        appendVertex(next(h));
      } else {
        out.push_back(edgePoint(h, s));
        lastVertex = -1;
      }
    }
    length += along.norm();
    at = to;
    if (!atEnd) {
      const int h = crossing(run.first);
      appendVertex(bends_[leg].onLeft ? next(h) : h);
      portal = run.last + 1;
    }
  }
  out.push_back(to_);
  return length;
}

bool liesInFace(const TriangleMesh& mesh, const PointLocation& point, int f) {
  if (point.face == f) return true;
  if (point.simplex == Simplex::kEdge) {
    const int t = mesh.twin[point.halfedge];
    return t >= 0 && faceOf(t) == f;
  }
  return point.simplex == Simplex::kVertex &&
         (mesh.corner(f, 0) == point.vertex || mesh.corner(f, 1) == point.vertex ||
          mesh.corner(f, 2) == point.vertex);
}

int commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const PointLocation onA = locate(mesh, a);
  const PointLocation onB = locate(mesh, b);
  if (onA.simplex != Simplex::kVertex) {
    if (liesInFace(mesh, onB, a.face)) return a.face;
    const int t = onA.simplex == Simplex::kEdge ? mesh.twin[onA.halfedge] : -1;
    return t >= 0 && liesInFace(mesh, onB, faceOf(t)) ? faceOf(t) : -1;
  }
  for (const int h : outgoingHalfedges(mesh, onA.vertex)) {
    if (liesInFace(mesh, onB, faceOf(h))) return faceOf(h);
  }
  return -1;
}

double appendStripPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                       StripWorkspace& workspace, Array<SurfacePoint>& out) {
  Tightening tightening(geometry, from, to, workspace);
  tightening.run(false);
  return tightening.append(out);
}

double appendShorterStripPath(const Geometry& geometry, const SurfacePoint& from,
                              const SurfacePoint& to, StripWorkspace& workspace,
                              Array<SurfacePoint>& out) {
  Tightening tightening(geometry, from, to, workspace);
  tightening.run(true);
  return tightening.append(out);
}

Array<int> pointsWithoutRepetitions(const TriangleMesh& mesh, const Array<SurfacePoint>& points) {
  // The positions of one point, computed in two faces, differ by rounding.
  constexpr double kSamePoint = 1e-13;
  Array<int> kept;
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < points.count(); ++i) {
    const Vec3 here = position(mesh, points[i]);
    const double scale = here.cwiseAbs().maxCoeff();
    const bool same = i > 0 && (here - last).cwiseAbs().maxCoeff() <= kSamePoint * scale;
    const bool isLast = i == points.count() - 1;
    const bool needed =
        same &&
        (isLast ? kept.count() < 2 : !haveCommonFace(mesh, points[kept.back()], points[i + 1]));
    if (same && !needed) continue;
    kept.push_back(i);
    last = here;
  }
  return kept;
}

}  // namespace karcher

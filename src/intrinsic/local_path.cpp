#include "intrinsic/local_path.h"

namespace karcher {
namespace {

/// Joins two points of the faces at half-edge h by a straight line, if the line crosses the
/// half-edge.
bool joinAcross(const Geometry& geometry, const SurfacePoint& from, int h, const SurfacePoint& to,
                Array<SurfacePoint>& out) {
  const int t = geometry.mesh->twin[h];
  const double edge = geometry.edgeLength[h];
  // In the frame of h, the tail is at the origin, the head at (edge, 0), and the face of h above.
  const Vec2 here = oppositeOverHalfedge(geometry, h);
  const Vec2 there = oppositeOverHalfedge(geometry, t);
  const double fromApex = from.bary[cornerOf(previous(h))];
  const double toApex = to.bary[cornerOf(previous(t))];
  const Vec2 a(from.bary[cornerOf(next(h))] * edge + fromApex * here.x(), fromApex * here.y());
  const Vec2 b(to.bary[cornerOf(t)] * edge + toApex * (edge - there.x()), -toApex * there.y());
  if (!(a.y() > 0 && b.y() < 0)) return false;
  const double s = (a.x() + (b.x() - a.x()) * a.y() / (a.y() - b.y())) / edge;
  // At an end of the edge the path may be shorter around the other side of the vertex.
  if (!(s > kLocalRounding && s < 1 - kLocalRounding)) return false;
  out.push_back(edgePoint(h, s));
  out.push_back(to);
  return true;
}

}  // namespace

bool appendLocalPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     StripWorkspace& workspace, Array<SurfacePoint>& out,
                     const LocalPathOptions& options) {
  if (from.face == to.face) {
    out.push_back(to);
    return true;
  }
  const TriangleMesh& mesh = *geometry.mesh;
  for (int h = 3 * from.face; h < 3 * from.face + 3; ++h) {
    const int t = mesh.twin[h];
    if (t >= 0 && faceOf(t) == to.face && joinAcross(geometry, from, h, to, out)) {
      return true;
    }
  }
  if (!searchStrip(mesh, from, to, {.maxFaces = options.maxFaces}, workspace.search,
                   workspace.strip)) {
    return false;
  }
  appendStripPath(geometry, from, to, workspace, out);
  return true;
}

}  // namespace karcher

#include "peers/descent.h"

#include <algorithm>
#include <string>

#include "intrinsic/strip_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

class Descent {
 public:
  Descent(const Geometry& geometry, const Array<double>& distances, const SurfacePoint& source)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        distances_(distances),
        source_(source),
        sourceLocation_(locate(mesh_, source)) {}

  DescentPath run(const SurfacePoint& start) {
    path_.points.push_back(start);
    path_.stop = DescentStop::kLimit;
    for (int step = 0; step < mesh_.halfedgeCount(); ++step) {
      if (arrive()) {
        path_.stop = DescentStop::kArrived;
        break;
      }
      if (!goOn()) {
        path_.stop = DescentStop::kStuck;
        break;
      }
    }
    for (int i = 1; i < path_.points.count(); ++i) {
      path_.length +=
          (position(mesh_, path_.points[i]) - position(mesh_, path_.points[i - 1])).norm();
    }
    return path_;
  }

 private:
  /// Ends the path at the source if a face of the current point contains the source.
  bool arrive() {
    const PointLocation here = locate(mesh_, path_.points.back());
    const auto endIn = [&](int f) {
      if (!liesInFace(mesh_, sourceLocation_, f)) return false;
      path_.points.push_back(inFace(mesh_, source_, f));
      return true;
    };
    if (here.simplex != Simplex::kVertex) {
      if (endIn(here.face)) return true;
      const int twin = here.simplex == Simplex::kEdge ? mesh_.twin[here.halfedge] : -1;
      return twin >= 0 && endIn(faceOf(twin));
    }
    for (const int h : outgoingHalfedges(mesh_, here.vertex)) {
      if (endIn(faceOf(h))) return true;
    }
    return false;
  }

  bool goOn() {
    const SurfacePoint here = path_.points.back();
    const PointLocation location = locate(mesh_, here);
    if (location.simplex == Simplex::kVertex) return leaveVertex(location.vertex);
    if (location.simplex == Simplex::kEdge) return leaveEdge(here, location.halfedge);
    return crossFace(here);
  }

  /// The distance of a vertex at the path. Other vertices may have infinite distances, such as
  /// those on other components.
  double distanceOf(int vertex) const {
    const double distance = distances_[vertex];
    if (std::isfinite(distance)) return distance;
    throw Error(ErrorCode::kNotFinite,
                "the distance of vertex " + std::to_string(vertex) + " is not a finite number");
  }

  Vec2 downhill(int f) const {
    for (int k = 0; k < 3; ++k) distanceOf(mesh_.corner(f, k));
    return -faceGradient(geometry_, distances_, f);
  }

  /// Whether the descent direction in the face of h leads away from h into the face.
  bool leadsInside(int h) const {
    return cross(halfedgeInFace(geometry_, h), downhill(faceOf(h))) > 0;
  }

  bool leaveEdge(const SurfacePoint& here, int h) {
    const int twin = mesh_.twin[h];
    // The path comes from the point's own face, so it tries the other face first.
    if (twin >= 0 && leadsInside(twin)) {
      return crossFace(edgePoint(twin, here.bary[cornerOf(h)]));
    }
    if (leadsInside(h)) return crossFace(here);
    return followEdge(h);
  }

  bool followEdge(int h) {
    const double change = distanceOf(mesh_.head(h)) - distanceOf(mesh_.tail(h));
    if (change == 0) return false;
    path_.points.push_back(change < 0 ? edgePoint(next(h), 0) : edgePoint(h, 0));
    return true;
  }

  /// Moves from a point of a face to the point where the descent leaves the face.
  bool crossFace(const SurfacePoint& from) {
    const Vec2 direction = downhill(from.face);
    const Vec3 rates = barycentric(geometry_, from.face, direction) -
                       barycentric(geometry_, from.face, Vec2::Zero());
    double length = kInfinity;
    int corner = -1;
    for (int k = 0; k < 3; ++k) {
      if (rates[k] >= 0 || from.bary[k] == 0) continue;
      if (from.bary[k] / -rates[k] < length) {
        length = from.bary[k] / -rates[k];
        corner = k;
      }
    }
    if (corner < 0) return false;
    Vec3 bary = (from.bary + length * rates).cwiseMax(0);
    bary[corner] = 0;
    path_.points.push_back(clampedPoint(from.face, bary));
    return true;
  }

  /// Follows the steepest descent from a vertex, through a corner or along an edge.
  bool leaveVertex(int vertex) {
    double steepest = 0;
    int bestCorner = -1;
    int bestEdge = -1;
    for (const int h : outgoingHalfedges(mesh_, vertex)) {
      const Vec2 direction = downhill(faceOf(h));
      const bool inCorner = cross(halfedgeInFace(geometry_, h), direction) > 0 &&
                            cross(halfedgeInFace(geometry_, previous(h)), direction) > 0;
      if (inCorner && direction.norm() > steepest) {
        steepest = direction.norm();
        bestCorner = h;
        bestEdge = -1;
      }
      considerEdge(h, vertex, mesh_.head(h), steepest, bestEdge);
      const int last = previous(h);
      if (mesh_.twin[last] < 0) considerEdge(last, vertex, mesh_.tail(last), steepest, bestEdge);
    }
    if (bestEdge >= 0) return followEdge(bestEdge);
    return bestCorner >= 0 && crossFace(edgePoint(bestCorner, 0));
  }

  void considerEdge(int h, int from, int to, double& steepest, int& bestEdge) const {
    const double slope = (distanceOf(from) - distanceOf(to)) / geometry_.edgeLength[h];
    if (slope <= steepest) return;
    steepest = slope;
    bestEdge = h;
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const Array<double>& distances_;
  const SurfacePoint source_;
  const PointLocation sourceLocation_;
  DescentPath path_;
};

}  // namespace

Vec2 faceGradient(const Geometry& geometry, const Array<double>& values, int f) {
  const double base = values[geometry.mesh->corner(f, 0)];
  const double alongX = (values[geometry.mesh->corner(f, 1)] - base) / geometry.edgeLength[3 * f];
  const double toApex = values[geometry.mesh->corner(f, 2)] - base;
  const Vec2& apex = geometry.apex[f];
  return {alongX, (toApex - alongX * apex.x()) / apex.y()};
}

DescentPath descendDistance(const Geometry& geometry, const Array<double>& distances,
                            const SurfacePoint& source, const SurfacePoint& start) {
  if (distances.count() != geometry.mesh->vertexCount()) {
    throw Error(ErrorCode::kBadArgument,
                "there are " + std::to_string(distances.count()) + " distances, but the mesh has " +
                    std::to_string(geometry.mesh->vertexCount()) + " vertices");
  }
  return Descent(geometry, distances, source).run(start);
}

SearchEnd descentCenterOfMass(const Geometry& geometry, const DescentPath& path, Weights weights) {
  if (weights.size() != 2 || !(weights[0] >= 0) || !(weights[1] >= 0) ||
      std::abs(weights[0] + weights[1] - 1) > 1e-9) {
    throw Error(ErrorCode::kBadWeights,
                "descent has a center of mass for two points only, with weights that are at least "
                "0 and sum to 1");
  }
  SearchEnd center;
  if (path.stop != DescentStop::kArrived) center.status = Status::kNoProgress;
  const TriangleMesh& mesh = *geometry.mesh;
  double left = weights[0] * path.length;
  center.point = path.points.front();
  for (int i = 1; i < path.points.count(); ++i) {
    const Vec3 from = position(mesh, path.points[i - 1]);
    const Vec3 to = position(mesh, path.points[i]);
    const double piece = (to - from).norm();
    center.point = path.points[i];
    if (left <= piece) {
      // Interpolation needs both ends of the piece in one face: the face of the later end or, if
      // the earlier end does not lie in it, the face of the earlier end.
      const bool later = liesInFace(mesh, locate(mesh, path.points[i - 1]), path.points[i].face);
      const int f = later ? path.points[i].face : path.points[i - 1].face;
      const Vec3 a = inFace(mesh, path.points[i - 1], f).bary;
      const Vec3 b = inFace(mesh, path.points[i], f).bary;
      const double part = piece > 0 ? left / piece : 0;
      center.point = clampedPoint(f, (1 - part) * a + part * b);
      break;
    }
    left -= piece;
  }
  return center;
}

}  // namespace karcher

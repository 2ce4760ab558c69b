#include "intrinsic/straighten.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The half-edge that leaves a vertex, in one of the vertex's faces.
int leaving(const TriangleMesh& mesh, int face, int vertex) {
  int h = 3 * face;
  while (mesh.tail(h) != vertex) ++h;
  return h;
}

/// The strip of faces along a chain of points, from face to face.
class ChainStrip {
 public:
  ChainStrip(const Geometry& geometry, Strip& strip)
      : geometry_(geometry), mesh_(*geometry.mesh), strip_(strip) {}

  void build(const Array<SurfacePoint>& points) {
    const int count = points.count();
    begin(count > 1 ? sharedFace(points, 0) : points[0].face);
    for (int i = 1; i < count; ++i) {
      if (points[i].face == face_) continue;
      const PointLocation to = locate(mesh_, points[i]);
      if (!liesInFace(mesh_, to, face_)) leave(points, i - 1, to);
    }
  }

  /// The face in which the strip ends.
  int lastFace() const { return face_; }

  /// Appends the crossings of another strip, which begins in the last face.
  void append(const Array<int>& crossings) {
    for (const int h : crossings) cross(h);
  }

 private:
  int sharedFace(const Array<SurfacePoint>& points, int i) const {
    const int face = commonFace(mesh_, points[i], points[i + 1]);
    if (face < 0) {
      throw Error(ErrorCode::kBadArgument, "the points " + std::to_string(i) + " and " +
                                               std::to_string(i + 1) +
                                               " of the path have no face in common");
    }
    return face;
  }

  void begin(int face) {
    strip_.face = face_ = face;
    strip_.crossings.clear();
  }

  void cross(int h) {
    // A step over an edge and straight back cancels.
    if (!strip_.crossings.empty() && strip_.crossings.back() == mesh_.twin[h]) {
      strip_.crossings.pop_back();
    } else {
      strip_.crossings.push_back(h);
    }
    face_ = faceOf(mesh_.twin[h]);
  }

  /// Extends the strip from the last face, through point `at` of the chain, to a face that contains
  /// the next point.
  void leave(const Array<SurfacePoint>& points, int at, const PointLocation& to) {
    const PointLocation here = locate(mesh_, points[at]);
    if (here.simplex == Simplex::kVertex) {
      // The last earlier point at another place, or -1.
      int from = at - 1;
      while (from >= 0 && samePlace(mesh_, points[from], points[at])) --from;
      const int target = sharedFace(points, at);
      turnAround(here.vertex, to, turnsLeft(points, from, here.vertex, points[at + 1], target));
    } else if (here.simplex == Simplex::kEdge) {
      const int h = here.face == face_ ? here.halfedge : mesh_.twin[here.halfedge];
      if (mesh_.twin[h] < 0 || !liesInFace(mesh_, to, faceOf(mesh_.twin[h]))) {
        sharedFace(points, at);
      }
      cross(h);
    } else {
      sharedFace(points, at);
    }
  }

  /// The unscaled direction from a corner of a face to a point of the face.
  double direction(int vertex, int face, const SurfacePoint& point) const {
    const int h = leaving(mesh_, face, vertex);
    return directionAtTail(geometry_, h, stepInFace(geometry_, face, edgePoint(h, 0), point));
  }

  /// Whether the strip turns counterclockwise around a vertex from the last face to `target`. It
  /// turns on the side with less angle between the path's pieces.
  bool turnsLeft(const Array<SurfacePoint>& points, int from, int vertex, const SurfacePoint& to,
                 int target) const {
    const int here = leaving(mesh_, face_, vertex);
    const int there = leaving(mesh_, target, vertex);
    // Around a boundary vertex only one sense leads to `target`. Rounding must not decide the
    // sense, even if the path turns straight back.
    if (mesh_.onBoundary[vertex]) {
      return geometry_.cumulatedAngle[there] > geometry_.cumulatedAngle[here];
    }
    const double outgoing = direction(vertex, target, to);
    const double total = geometry_.totalAngle[vertex];
    // If the path begins at the vertex, both senses are equally good.
    const double incoming =
        from >= 0 ? direction(vertex, face_, points[from]) : geometry_.cumulatedAngle[here];
    double left = outgoing - incoming;
    if (left < 0) left += total;
    // If the path turns straight back along an edge, `target` lies across this edge. The strip
    // crosses only this edge.
    if (std::min(left, total - left) < kChainRounding) return there == mesh_.twin[previous(here)];
    if (std::abs(2 * left - total) > kChainRounding) return 2 * left < total;
    return leastNeighbor(vertex, target, true) < leastNeighbor(vertex, target, false);
  }

  /// The smallest index of a vertex's neighbours on a turn in one sense from the last face to
  /// `target`. If both senses turn by equal angles, the smaller index decides, so that the reversed
  /// path takes the same side.
  int leastNeighbor(int vertex, int target, bool left) const {
    int h = leaving(mesh_, face_, vertex);
    int least = mesh_.vertexCount();
    while (faceOf(h) != target) {
      h = left ? mesh_.twin[previous(h)] : next(mesh_.twin[h]);
      least = std::min(least, mesh_.head(left ? h : mesh_.twin[previous(h)]));
    }
    return least;
  }

  void turnAround(int vertex, const PointLocation& to, bool left) {
    int h = leaving(mesh_, face_, vertex);
    while (!liesInFace(mesh_, to, faceOf(h))) {
      const int out = left ? previous(h) : h;
      cross(out);
      h = left ? mesh_.twin[out] : next(mesh_.twin[out]);
    }
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Strip& strip_;
  int face_ = -1;
};

/// Replaces a path by the tight path in the workspace's strip. `from` and `to` may be the path's
/// own points.
void replaceByTight(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                    StripWorkspace& workspace, SurfacePath& path) {
  const SurfacePoint ends[] = {from, to};
  path.points.clear();
  path.points.push_back(ends[0]);
  appendStripPath(geometry, ends[0], ends[1], workspace, path.points);
  measure(*geometry.mesh, path);
}

}  // namespace

void straighten(const Geometry& geometry, SurfacePath& path, StripWorkspace& workspace) {
  if (path.points.count() < 2) return;
  ChainStrip(geometry, workspace.strip).build(path.points);
  replaceByTight(geometry, path.start(), path.end(), workspace, path);
}

bool moveEnd(const Geometry& geometry, const SurfacePoint& end, SurfacePath& path,
             StripWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (haveCommonFace(mesh, path.end(), end)) {
    path.points.push_back(end);
    straighten(geometry, path, workspace);
    return true;
  }
  ChainStrip chain(geometry, workspace.strip);
  chain.build(path.points);
  Strip& motion = workspace.motion;
  if (!searchStrip(mesh, path.end(), end,
                   {.maxFaces = mesh.faceCount(), .firstFace = chain.lastFace()}, workspace.search,
                   motion)) {
    return false;
  }
  chain.append(motion.crossings);
  replaceByTight(geometry, path.start(), end, workspace, path);
  return true;
}

bool moveStart(const Geometry& geometry, const SurfacePoint& start, SurfacePath& path,
               StripWorkspace& workspace) {
  std::reverse(path.points.begin(), path.points.end());
  const bool moved = moveEnd(geometry, start, path, workspace);
  std::reverse(path.points.begin(), path.points.end());
  if (moved) measure(*geometry.mesh, path);
  return moved;
}

}  // namespace karcher

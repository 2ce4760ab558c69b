#include "intrinsic/surface_path.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// Angles around a vertex that differ by less are taken for equal.
constexpr double kSameAngle = 1e-9;

/// Whether two points, at the locations given, are the same, seen from whatever faces.
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const PointLocation& atA,
               const SurfacePoint& b, const PointLocation& atB) {
  if (a.face == b.face) return a.bary == b.bary;
  if (atA.simplex != atB.simplex || atA.simplex == Simplex::kFace) return false;
  if (atA.simplex == Simplex::kVertex) return atA.vertex == atB.vertex;
  return mesh.twin[atA.halfedge] == atB.halfedge &&
         a.bary[cornerOf(atA.halfedge)] == b.bary[cornerOf(next(atB.halfedge))];
}

bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return samePlace(mesh, a, locate(mesh, a), b, locate(mesh, b));
}

/// The half-edge that leaves a vertex in a face that holds it.
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

  /// The face that the strip ends in.
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
    // A strip that steps over an edge and straight back does neither.
    if (!strip_.crossings.empty() && strip_.crossings.back() == mesh_.twin[h]) {
      strip_.crossings.pop_back();
    } else {
      strip_.crossings.push_back(h);
    }
    face_ = faceOf(mesh_.twin[h]);
  }

  /// Leaves the last face through point `at` of the chain, which lies in it, for a face that holds
  /// the point after it.
  void leave(const Array<SurfacePoint>& points, int at, const PointLocation& to) {
    const PointLocation here = locate(mesh_, points[at]);
    if (here.simplex == Simplex::kVertex) {
      // The last point that lies elsewhere.
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

  /// Direction of a point at a vertex, both in the face, unscaled.
  double direction(int vertex, int face, const SurfacePoint& point) const {
    const int h = leaving(mesh_, face, vertex);
    return directionAtTail(geometry_, h,
                           pointInFace(geometry_, inFace(mesh_, point, face)) -
                               cornerInFace(geometry_, face, cornerOf(h)));
  }

  /// Whether the way around a vertex from the last face to `target` is counterclockwise: on the
  /// side where the surface has less angle between the path's pieces.
  bool turnsLeft(const Array<SurfacePoint>& points, int from, int vertex, const SurfacePoint& to,
                 int target) const {
    const int here = leaving(mesh_, face_, vertex);
    const int there = leaving(mesh_, target, vertex);
    // The faces around a vertex of the boundary are in one order, whatever rounding makes of a path
    // that turns straight back.
    if (mesh_.onBoundary[vertex]) {
      return geometry_.cumulatedAngle[there] > geometry_.cumulatedAngle[here];
    }
    const double outgoing = direction(vertex, target, to);
    const double total = geometry_.totalAngle[vertex];
    // Where the path begins at the vertex, every way is as good.
    const double incoming =
        from >= 0 ? direction(vertex, face_, points[from]) : geometry_.cumulatedAngle[here];
    double left = outgoing - incoming;
    if (left < 0) left += total;
    // Straight back along an edge, from the face on one side to that on the other.
    if (std::min(left, total - left) < kSameAngle) return there == mesh_.twin[previous(here)];
    if (std::abs(2 * left - total) > kSameAngle) return 2 * left < total;
    return leastNeighbor(vertex, target, true) < leastNeighbor(vertex, target, false);
  }

  /// The least number of a vertex between the last face and another around a vertex, one way round:
  /// it tells the sides apart, whichever way the path runs.
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

/// Calls append(point) for each point of the part of a path between two lengths.
template <class Append>
void forEachOfPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                   const Append& append) {
  append(pointAlong(mesh, path, from));
  if (path.points.count() == 1) return;
  const int first = pieceAt(path.lengths, from);
  const int last = pieceAt(path.lengths, to);
  if (from <= to) {
    for (int i = first + 1; i <= last; ++i) append(path.points[i]);
  } else {
    for (int i = first; i > last; --i) append(path.points[i]);
  }
  append(pointAlong(mesh, path, to));
}

/// Replaces a path by the tight one in the workspace's strip. Its ends may be the path's own
/// points.
void replaceByTight(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                    StripWorkspace& workspace, SurfacePath& path) {
  const SurfacePoint ends[] = {from, to};
  path.points.clear();
  path.points.push_back(ends[0]);
  appendStripPath(geometry, ends[0], ends[1], workspace, path.points);
  measure(*geometry.mesh, path);
}

}  // namespace

void measure(const TriangleMesh& mesh, SurfacePath& path) {
  path.lengths.clear();
  path.lengths.push_back(0);
  Vec3 last = position(mesh, path.points.front());
  for (int i = 1; i < path.points.count(); ++i) {
    const Vec3 here = position(mesh, path.points[i]);
    path.lengths.push_back(path.lengths.back() + (here - last).norm());
    last = here;
  }
}

void appendPoint(const TriangleMesh& mesh, const SurfacePoint& point, SurfacePath& path) {
  if (path.points.empty()) {
    path.points.push_back(point);
    path.lengths.assign(1, 0.0);
  } else if (!samePlace(mesh, path.points.back(), point)) {
    const double piece = (position(mesh, point) - position(mesh, path.points.back())).norm();
    path.lengths.push_back(path.lengths.back() + piece);
    path.points.push_back(point);
  }
}

SurfacePath pathThrough(const TriangleMesh& mesh, Array<SurfacePoint> points) {
  SurfacePath path;
  path.points = std::move(points);
  measure(mesh, path);
  return path;
}

SurfacePoint pointBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b,
                          double s) {
  const int face = commonFace(mesh, a, b);
  if (face < 0) return s < 0.5 ? a : b;
  const Vec3 from = inFace(mesh, a, face).bary;
  return clampedPoint(face, from + s * (inFace(mesh, b, face).bary - from));
}

int pieceAt(const Array<double>& lengths, double length) {
  const auto beyond = std::upper_bound(lengths.begin(), lengths.end(), length);
  return std::clamp(static_cast<int>(beyond - lengths.begin()) - 1, 0, lengths.count() - 2);
}

SurfacePoint pointAlong(const TriangleMesh& mesh, const SurfacePath& path, double length) {
  const auto& [points, lengths] = path;
  if (points.count() == 1) return points.front();
  const int k = pieceAt(lengths, length);
  const double piece = lengths[k + 1] - lengths[k];
  const double s = piece > 0 ? std::clamp((length - lengths[k]) / piece, 0.0, 1.0) : 0;
  if (s == 0) return points[k];
  if (s == 1) return points[k + 1];
  return pointBetween(mesh, points[k], points[k + 1], s);
}

void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                SurfacePath& out) {
  Vec3 last = out.points.empty() ? Vec3::Zero() : position(mesh, out.points.back());
  forEachOfPart(mesh, path, from, to, [&](const SurfacePoint& point) {
    if (!out.points.empty() && samePlace(mesh, out.points.back(), point)) return;
    const Vec3 here = position(mesh, point);
    out.lengths.push_back(out.points.empty() ? 0 : out.lengths.back() + (here - last).norm());
    out.points.push_back(point);
    last = here;
  });
}

void appendPart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
                Array<SurfacePoint>& out) {
  PointLocation last;
  if (!out.empty()) last = locate(mesh, out.back());
  forEachOfPart(mesh, path, from, to, [&](const SurfacePoint& point) {
    const PointLocation at = locate(mesh, point);
    if (!out.empty() && samePlace(mesh, out.back(), last, point, at)) return;
    out.push_back(point);
    last = at;
  });
}

void reverse(SurfacePath& path) {
  const double length = path.length();
  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.lengths.begin(), path.lengths.end());
  for (double& at : path.lengths) at = length - at;
}

SurfacePath reversed(SurfacePath path) {
  reverse(path);
  return path;
}

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

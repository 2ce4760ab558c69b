#include "intrinsic/surface_path.h"

#include <algorithm>

#include "intrinsic/strip_path.h"

namespace karcher {
namespace {

/// Whether two points, at the given locations, are the same place. Their faces may differ.
bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const PointLocation& atA,
               const SurfacePoint& b, const PointLocation& atB) {
  if (a.face == b.face) return a.bary == b.bary;
  if (atA.simplex != atB.simplex || atA.simplex == Simplex::kFace) return false;
  if (atA.simplex == Simplex::kVertex) return atA.vertex == atB.vertex;
  const int h = atA.halfedge;
  const int t = atB.halfedge;
  // From one face to the other, 1 - (1 - s) may differ from s.
  return mesh.twin[h] == t && (a.bary[cornerOf(h)] == b.bary[cornerOf(next(t))] ||
                               a.bary[cornerOf(next(h))] == b.bary[cornerOf(t)]);
}

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

}  // namespace

bool samePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return samePlace(mesh, a, locate(mesh, a), b, locate(mesh, b));
}

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

}  // namespace karcher

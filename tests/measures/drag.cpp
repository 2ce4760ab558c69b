#include "measures/drag.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "intrinsic/strip_path.h"

namespace karcher {
namespace {

/// The ends of the edges that a path crosses, by their side of the path.
struct Sides {
  std::set<int> left;
  std::set<int> right;
};

Sides sidesOf(const TriangleMesh& mesh, const Array<SurfacePoint>& path) {
  Sides sides;
  for (int i = 1; i + 1 < path.count(); ++i) {
    const int face = commonFace(mesh, path[i - 1], path[i]);
    if (liesInFace(mesh, locate(mesh, path[i + 1]), face)) continue;  // the path stays in it
    const PointLocation at = locate(mesh, inFace(mesh, path[i], face));
    if (at.simplex != Simplex::kEdge) continue;
    // The face lies to the left of its half-edge, so the path leaves it with the head to its left.
    sides.left.insert(mesh.head(at.halfedge));
    sides.right.insert(mesh.tail(at.halfedge));
  }
  return sides;
}

/// The unit vector along the first piece with positive length.
Vec3 directionAlong(const TriangleMesh& mesh, const Array<SurfacePoint>& path, bool backwards) {
  const int n = path.count();
  const Vec3 from = position(mesh, path[backwards ? n - 1 : 0]);
  for (int i = 1; i < n; ++i) {
    const Vec3 along = position(mesh, path[backwards ? n - 1 - i : i]) - from;
    if (along.norm() > 0) return along.normalized();
  }
  return Vec3::Zero();
}

}  // namespace

double anglesBetween(const TriangleMesh& mesh, const Array<SurfacePoint>& before,
                     const Array<SurfacePoint>& after) {
  double sum = 0;
  for (const bool backwards : {false, true}) {
    const Vec3 a = directionAlong(mesh, before, backwards);
    const Vec3 b = directionAlong(mesh, after, backwards);
    sum += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return sum;
}

Array<VertexPassage> passedVertices(const Geometry& geometry, const Array<SurfacePoint>& before,
                                    const Array<SurfacePoint>& after) {
  const Sides from = sidesOf(*geometry.mesh, before);
  const Sides to = sidesOf(*geometry.mesh, after);
  Array<VertexPassage> passages;
  const auto pass = [&](const std::set<int>& had, const std::set<int>& has) {
    for (const int v : had) {
      const double curvature = 2 * kPi - geometry.totalAngle[v];
      if (has.count(v) != 0 && curvature > 0 && geometry.mesh->onBoundary[v] == 0) {
        passages.push_back({v, curvature});
      }
    }
  };
  pass(from.left, to.right);
  pass(from.right, to.left);
  return passages;
}

double countStep(DragFigures& figures, const MeasuredPolyline& before,
                 const MeasuredPolyline& after, double step, double allowedLeap,
                 const std::function<double()>& allowedBeside) {
  const double motion = hausdorffDistance(before, after, DragFigures::kTolerance * step) / step;
  double allowed = allowedLeap / step;
  if (allowed > DragFigures::kShiver) {
    ++figures.passing;
    if (motion > allowed && allowedBeside) allowed += allowedBeside() / step;
    figures.beyond += motion > allowed;
    figures.largestPassing = std::max(figures.largestPassing, motion / allowed);
    return motion;
  }
  ++figures.steps;
  figures.shivers += motion > DragFigures::kShiver;
  figures.largestLeap = std::max(figures.largestLeap, motion);
  return motion;
}

void add(DragFigures& sum, const DragFigures& figures) {
  sum.steps += figures.steps;
  sum.shivers += figures.shivers;
  sum.passing += figures.passing;
  sum.beyond += figures.beyond;
  sum.largestLeap = std::max(sum.largestLeap, figures.largestLeap);
  sum.largestPassing = std::max(sum.largestPassing, figures.largestPassing);
}

}  // namespace karcher

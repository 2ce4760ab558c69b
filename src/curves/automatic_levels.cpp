#include "curves/automatic_levels.h"

#include <algorithm>
#include <cmath>

#include "mesh/error.h"

namespace karcher {
namespace {

/// Legs shorter than this, in mean edges, are not refined further: what is left is the mesh itself.
constexpr double kShortestLeg = 1;

/// The square of a leg's length times the absolute curvature per area of the faces that it crosses.
double curvatureAlong(const Geometry& geometry, const SurfacePath& leg) {
  const TriangleMesh& mesh = *geometry.mesh;
  double curvature = 0;
  double area = 0;
  int last = -1;
  for (int i = 1; i < leg.points.count(); ++i) {
    const int face = commonFace(mesh, leg.points[i - 1], leg.points[i]);
    if (face < 0 || face == last) continue;
    last = face;
    area += doubleArea(geometry, face) / 2;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int vertex = mesh.tail(h);
      // The boundary's own curvature is that of its line.
      if (mesh.onBoundary[vertex]) continue;
      // A vertex's defect is shared out by its corners.
      const double defect = std::abs(2 * kPi - geometry.totalAngle[vertex]);
      curvature += defect * geometry.cornerAngle[h] / geometry.totalAngle[vertex];
    }
  }
  return area > 0 ? curvature / area * leg.length() * leg.length() : 0;
}

/// How many legs a piece's points reach over.
int reachOf(const CurveShape& shape, int points) {
  if (shape.kind == CurveKind::kBSpline) return shape.degree;
  if (shape.kind == CurveKind::kCatmullRom) return 3;
  return legCount(shape, points);
}

bool isAllowed(const CurveShape& shape, int points, int levels) {
  try {
    checkLevels(shape, points, levels);
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace

int automaticLevels(const Geometry& geometry, const CurveShape& shape, int points,
                    const Array<SurfacePath>& legs) {
  double curvature = 0;
  double longest = 0;
  for (const SurfacePath& leg : legs) {
    curvature = std::max(curvature, curvatureAlong(geometry, leg));
    longest = std::max(longest, leg.length());
  }
  const double reach = reachOf(shape, points) / 3.0;
  curvature *= reach * reach;
  const double shortEnough = kSmallLeg * geometry.meanEdge;
  if (curvature <= kSafeShare && longest <= shortEnough) return 0;
  // A Catmull-Rom curve's Bezier polygons have legs of a third.
  const double share = shape.kind == CurveKind::kCatmullRom ? 1.0 / 3 : 1;
  curvature *= share * share;
  longest *= share;
  int levels = 1;
  for (; levels < kMostLevels && isAllowed(shape, points, levels + 1); ++levels) {
    const double part = std::ldexp(1.0, -levels);
    const bool isSafe = curvature * part * part <= kSafeCurvature;
    if (isSafe && longest * part <= shortEnough) break;
    if (longest * part <= kShortestLeg * geometry.meanEdge) break;
  }
  return isAllowed(shape, points, levels) ? levels : 0;
}

bool takesMoreLevels(const Geometry& geometry, const CurveShape& shape, int points,
                     const RefinedPolygon& refined, int levels) {
  if (!isAllowed(shape, points, levels + 1)) return false;
  // A Catmull-Rom curve's pieces are cubic Bezier curves.
  const double reach = reachOf(shape, points) / 3.0;
  const double safe = std::ldexp(kSafeShare, levels);
  return std::any_of(refined.legs.begin(), refined.legs.end(), [&](const SurfacePath& leg) {
    return leg.length() > kShortestLeg * geometry.meanEdge &&
           curvatureAlong(geometry, leg) * reach * reach > safe;
  });
}

int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs) {
  double longest = 0;
  for (const SurfacePath& leg : legs) longest = std::max(longest, leg.length());
  int levels = isAllowed(shape, points, 2) ? 2 : 0;
  while (levels > 0 && levels < kMostLevels && isAllowed(shape, points, levels + 1) &&
         std::ldexp(longest, -levels) > 2 * geometry.meanEdge) {
    ++levels;
  }
  return levels;
}

}  // namespace karcher

#include "curves/polygon/convexity.h"

#include <algorithm>
#include <cmath>

namespace karcher {
namespace {

/// A leg across at most this many faces counts as having no detail: it is about one edge long, and
/// shows only the mesh itself.
constexpr int kFewFaces = 4;

/// The number of equal intervals of a piece's parameter. The convexity is computed at their ends.
constexpr int kParts = 16;

void layAlong(const Geometry& geometry, const Array<SurfacePath>& legs, const SegmentLayout& piece,
              ConvexityWorkspace& workspace) {
  workspace.places.assign(1, 0);
  workspace.curvatures.clear();
  workspace.points.assign(1, 0);
  for (int k = 1; k < piece.points.count(); ++k) {
    const SurfacePath& leg = legs[piece.points[k - 1]];
    const double before = workspace.points.back();
    for (int i = 1; i < leg.points.count(); ++i) {
      const int face = commonFace(*geometry.mesh, leg.points[i - 1], leg.points[i]);
      if (face < 0 || leg.lengths[i] == leg.lengths[i - 1]) continue;
      workspace.places.push_back(before + leg.lengths[i]);
      workspace.curvatures.push_back(curvatureOf(geometry, face));
    }
    workspace.points.push_back(before + leg.length());
  }
}

/// Writes d J' / J at all places on one side of `from`: after it if `onward`, otherwise before it.
void growJacobiField(const ConvexityWorkspace& along, double from, bool onward,
                     double* convexities) {
  const Array<double>& places = along.places;
  const int next =
      static_cast<int>(std::lower_bound(places.begin(), places.end(), from) - places.begin());
  double distance = 0;
  double field = 0;
  double derivative = 1;
  for (int i = onward ? next : next - 1; i >= 0 && i < places.count(); i += onward ? 1 : -1) {
    const double length = std::abs(places[i] - from) - distance;
    distance += length;
    if (distance == 0) continue;
    // The midpoint rule.
    const double middle = field + derivative * length / 2;
    const int face = std::clamp(onward ? i - 1 : i, 0, along.curvatures.count() - 1);
    const double after = derivative - along.curvatures[face] * middle * length;
    field += (derivative + after) / 2 * length;
    derivative = after;
    // The distance has a crease beyond a conjugate point.
    if (!(field > 0)) derivative = -kInfinity;
    convexities[i] = field > 0 ? distance * derivative / field : -kInfinity;
  }
}

}  // namespace

double curvatureOf(const Geometry& geometry, int face) {
  const TriangleMesh& mesh = *geometry.mesh;
  double curvature = 0;
  for (int h = 3 * face; h < 3 * face + 3; ++h) {
    const int vertex = mesh.tail(h);
    // At a boundary vertex, the angles show how the boundary line bends, not the surface.
    if (mesh.onBoundary[vertex]) continue;
    const double defect = 2 * kPi - geometry.totalAngle[vertex];
    curvature += defect * geometry.cornerAngle[h] / geometry.totalAngle[vertex];
  }
  return 2 * curvature / doubleArea(geometry, face);
}

double leastConvexity(const Geometry& geometry, const Array<SurfacePath>& legs,
                      const SegmentLayout& piece, const Array<double>& pointWeights,
                      ConvexityWorkspace& workspace) {
  layAlong(geometry, legs, piece, workspace);
  const Array<double>& places = workspace.places;
  const int count = places.count();
  const int points = piece.points.count();
  workspace.convexities.assign(static_cast<size_t>(points) * places.size(), 1);
  for (int k = 0; k < points; ++k) {
    double* convexities = workspace.convexities.data() + static_cast<size_t>(k) * places.size();
    growJacobiField(workspace, workspace.points[k], true, convexities);
    growJacobiField(workspace, workspace.points[k], false, convexities);
  }
  double least = 1;
  for (int part = 0; part <= kParts; ++part) {
    weightsAt(piece.basis, pointWeights, static_cast<double>(part) / kParts, workspace.weights);
    // The place along the legs that the curve has reached.
    double place = 0;
    for (int k = 0; k < points; ++k) place += workspace.weights[k] * workspace.points[k];
    const auto after = std::lower_bound(places.begin(), places.end(), place) - places.begin();
    const int at = std::min(static_cast<int>(after), count - 1);
    double convexity = 0;
    for (int k = 0; k < points; ++k) {
      // Zero times infinity would be NaN.
      if (workspace.weights[k] == 0) continue;
      convexity += workspace.weights[k] * workspace.convexities[k * count + at];
    }
    if (std::isnan(convexity)) return -kInfinity;
    least = std::min(least, convexity);
  }
  return least;
}

double detailAlong(const Geometry& geometry, const SurfacePath& leg) {
  double detail = 0;
  double area = 0;
  double curvatureBefore = 0;
  double areaBefore = 0;
  int last = -1;
  int faces = 0;
  for (int i = 1; i < leg.points.count(); ++i) {
    const int face = commonFace(*geometry.mesh, leg.points[i - 1], leg.points[i]);
    if (face < 0 || face == last) continue;
    ++faces;
    const double curvatureHere = curvatureOf(geometry, face);
    const double areaHere = doubleArea(geometry, face) / 2;
    if (last >= 0) {
      detail += (areaBefore + areaHere) / 2 * std::abs(curvatureHere - curvatureBefore);
    }
    area += areaHere;
    curvatureBefore = curvatureHere;
    areaBefore = areaHere;
    last = face;
  }

  return faces > kFewFaces ? detail / area * leg.length() * leg.length() : 0;
}

}  // namespace karcher

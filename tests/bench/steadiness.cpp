#include "steadiness.h"

#include <algorithm>

#include "bench_support.h"
#include "curves/polygon/levels.h"
#include "intrinsic/straighten.h"

namespace karcher {
namespace {

double lengthOf(const Array<Vec3>& polyline) {
  double sum = 0;
  for (int i = 1; i < polyline.count(); ++i) sum += (polyline[i] - polyline[i - 1]).norm();
  return sum;
}

Array<Vec3> positionsOf(const TriangleMesh& mesh, const Array<SurfacePoint>& path) {
  Array<Vec3> positions;
  for (const SurfacePoint& p : path) positions.push_back(position(mesh, p));
  return positions;
}

/// The largest leap of a curve when a geodesic of some length changes into another one: half of the
/// length times the curvature between both. This is the curvature of vertices next to both
/// geodesics. If these are farther than an edge apart, it follows from the angles between them.
double allowedByPassing(const Geometry& geometry, double length, const Array<SurfacePoint>& before,
                        const Array<SurfacePoint>& after) {
  const TriangleMesh& mesh = *geometry.mesh;
  double curvature = 0;
  for (const VertexPassage& passage : passedVertices(geometry, before, after)) {
    curvature += passage.curvature;
  }
  constexpr double kTolerance = 0.1;
  const double apart =
      hausdorffDistance(MeasuredPolyline(positionsOf(mesh, before)),
                        MeasuredPolyline(positionsOf(mesh, after)), kTolerance * geometry.meanEdge);
  if (apart > geometry.meanEdge) {
    curvature = std::max(curvature, anglesBetween(mesh, before, after));
  }
  return length / 2 * curvature;
}

/// The largest leap that passages of the legs between two tracings allow.
double allowedLeap(const Geometry& geometry, const TracedCurve& before, const TracedCurve& after) {
  double sum = 0;
  for (int i = 0; i < std::min(before.legs.count(), after.legs.count()); ++i) {
    const Array<SurfacePoint>& leg = before.legs[i];
    const double length = pathThrough(*geometry.mesh, leg).length();
    sum += allowedByPassing(geometry, length, leg, after.legs[i]);
  }
  return sum;
}

/// Appends the paths that carry the averages of a Bezier polygon: the rows of de Casteljau's
/// pyramid under the legs, then those of its halves.
void appendAveragedPaths(const Geometry& geometry, const LeggedPolygon& polygon, int levels,
                         AveragingWorkspace& workspace, Array<SurfacePath>& out) {
  if (levels == 0) return;
  for (Array<SurfacePath> row = polygon.legs; row.count() > 1;) {
    Array<SurfacePath> next;
    for (int i = 0; i + 1 < row.count(); ++i) {
      SurfacePath inner;
      appendPart(*geometry.mesh, row[i], row[i].length() / 2, row[i].length(), inner);
      appendPart(*geometry.mesh, row[i + 1], 0, row[i + 1].length() / 2, inner);
      straighten(geometry, inner, workspace.strip);
      next.push_back(inner);
    }
    out.insert(out.end(), next.begin(), next.end());
    row = std::move(next);
  }
  BezierHalves halves;
  halve(geometry, polygon, workspace, halves);
  appendAveragedPaths(geometry, halves.first, levels - 1, workspace, out);
  appendAveragedPaths(geometry, halves.second, levels - 1, workspace, out);
}

Array<SurfacePath> averagedPaths(const Geometry& geometry, const TracedCurve& curve) {
  LeggedPolygon polygon;
  for (const Array<SurfacePoint>& leg : curve.legs) {
    if (polygon.points.empty()) polygon.points.push_back({leg.front(), 1});
    polygon.points.push_back({leg.back(), 1});
    polygon.legs.push_back(pathThrough(*geometry.mesh, leg));
  }
  AveragingWorkspace workspace;
  Array<SurfacePath> paths;
  appendAveragedPaths(geometry, polygon, curve.levels, workspace, paths);
  return paths;
}

/// The largest leap that passages of the averages' paths between two tracings allow.
double allowedByAverages(const Geometry& geometry, const TracedCurve& before,
                         const TracedCurve& after) {
  const Array<SurfacePath> from = averagedPaths(geometry, before);
  const Array<SurfacePath> to = averagedPaths(geometry, after);
  double sum = 0;
  for (int i = 0; i < std::min(from.count(), to.count()); ++i) {
    sum += allowedByPassing(geometry, from[i].length(), from[i].points, to[i].points);
  }
  return sum;
}

/// Records a step that counts, by its motion in steps of the hand.
void tellStep(AverageFigures& figures, double motion, double allowed) {
  if (motion > DragFigures::kShiver) {
    if (motion <= allowed) {
      ++figures.passing;
      figures.largestPassing = std::max(figures.largestPassing, motion / allowed);
      return;
    }
    ++figures.unexplained;
  }
  figures.largestLeap = std::max(figures.largestLeap, motion);
}

void addStages(HandFigures& figures, const TracedCurve& traced) {
  for (const StageTime& stage : traced.stages) {
    if (figures.stageMs.count(stage.name) == 0) figures.stages.push_back(stage.name);
    figures.stageMs[stage.name].push_back(stage.ms);
  }
  figures.ms.push_back(traced.ms);
}

/// Measures one drag of a variant, which has this index.
void measureDrag(Surface& surface, const SteadyVariant& variant, const Drag& drag, int number,
                 HandFigures& figures) {
  const Geometry& geometry = surface.geometry();
  HeldCurve curve = variant.hold(surface, drag.polygon);
  TracedCurve before = curve.drag(Drag::kPoint, drag.path[0]);
  MeasuredPolyline lineBefore(before.polyline);
  for (int i = 1; i < drag.path.count(); ++i) {
    TracedCurve after = curve.drag(Drag::kPoint, drag.path[i]);
    addStages(figures, after);
    figures.allocations.push_back(static_cast<double>(after.allocations));
    figures.bridged += after.bridged;
    figures.lost += after.lost;
    MeasuredPolyline lineAfter(after.polyline);
    const int counted = figures.motion.steps;
    const double step = Drag::kStep * geometry.meanEdge;
    const double byLegs = allowedLeap(geometry, before, after);
    const auto byAverages = [&] { return allowedByAverages(geometry, before, after); };
    Leap leap{number, i,
              countStep(figures.motion, lineBefore, lineAfter, step, byLegs, byAverages)};
    leap.allowedByLegs = byLegs / step;
    if (leap.motion > DragFigures::kShiver) leap.allowedByAverages = byAverages() / step;
    const double allowed = leap.allowedByLegs + leap.allowedByAverages;
    if (leap.motion > std::max(allowed, DragFigures::kShiver)) figures.leaps.push_back(leap);
    if (figures.motion.steps > counted) tellStep(figures.averages, leap.motion, allowed);
    before = std::move(after);
    lineBefore = std::move(lineAfter);
  }
  figures.released.push_back(partMoved(before.polyline, curve.release().polyline));
  if (!curve.releaseToAutomatic) return;
  const TracedCurve automatic = curve.releaseToAutomatic();
  figures.releasedToAutomatic.push_back(partMoved(before.polyline, automatic.polyline));
}

}  // namespace

double partMoved(const Array<Vec3>& from, const Array<Vec3>& to) {
  const double length = lengthOf(from);
  constexpr double kTolerance = 1e-5;
  return hausdorffDistance(MeasuredPolyline(from), MeasuredPolyline(to), kTolerance * length) /
         length;
}

CurveFigures measureCurves(const TurningMeasure& measure, Surface& surface,
                           const SteadyVariant& variant,
                           const Array<Array<SurfacePoint>>& polygons) {
  CurveFigures figures;
  for (const Array<SurfacePoint>& polygon : polygons) {
    TracedCurve traced;
    // The measurement includes all allocations of a first tracing, and its data for the mesh.
    figures.ms.push_back(processorTimed([&] { traced = variant.trace(surface, polygon); }));
    figures.turnings.push_back(turning(measure, traced.polyline));
    figures.bridged.push_back(traced.bridged);
    figures.corners.push_back(variant.corner(surface, polygon));
    figures.levels.push_back(traced.levels);
    figures.lost += traced.lost;
    figures.polylines.push_back(std::move(traced.polyline));
  }
  return figures;
}

Array<double> partsMoved(const CurveFigures& from, const CurveFigures& to) {
  Array<double> parts;
  for (int i = 0; i < from.polylines.count(); ++i) {
    parts.push_back(partMoved(from.polylines[i], to.polylines[i]));
  }
  return parts;
}

Drag randomDrag(const Geometry& geometry, Random& random, const ControlPolygonOptions& options,
                int steps) {
  Drag drag;
  while (drag.path.empty()) {
    drag.polygon = randomControlPolygon(geometry, random, options);
    const Vec2 direction = unitVector(random.uniform(-kPi, kPi));
    drag.path = dragPath(geometry, drag.polygon[Drag::kPoint], direction,
                         Drag::kStep * geometry.meanEdge, steps);
  }
  return drag;
}

Array<HandFigures> measureDrags(Surface& surface, const Array<SteadyVariant>& variants,
                                const Array<Drag>& drags) {
  Array<HandFigures> figures(variants.size());
  for (int d = 0; d < drags.count(); ++d) {
    for (int v = 0; v < variants.count(); ++v) {
      measureDrag(surface, variants[v], drags[d], d, figures[v]);
    }
  }
  for (HandFigures& f : figures) {
    std::sort(f.leaps.begin(), f.leaps.end(),
              [](const Leap& a, const Leap& b) { return a.motion > b.motion; });
  }
  return figures;
}

}  // namespace karcher

#include "curves/refine/along_legs.h"

#include <algorithm>
#include <utility>

#include "curves/spec/knots.h"
#include "intrinsic/straighten.h"

namespace karcher {
namespace {

/// The legs from the start of a run of legs to its end, through an average on each leg. They are
/// one more than the run has.
Array<SurfacePath> legsOver(const Geometry& geometry, const Array<SurfacePath>& run,
                            const Array<LegAverage>& averages) {
  const TriangleMesh& mesh = *geometry.mesh;
  StripWorkspace strip;
  Array<SurfacePath> legs(run.size() + 1);
  takePart(mesh, run.front(), 0, averages.front().at, legs.front());
  for (int i = 0; i + 1 < run.count(); ++i) {
    Chain chain(mesh, legs[i + 1]);
    chain.append(run[i], averages[i].at, run[i].length());
    chain.append(run[i + 1], 0, averages[i + 1].at);
    straighten(geometry, legs[i + 1], strip);
  }
  takePart(mesh, run.back(), averages.back().at, run.back().length(), legs.back());
  return legs;
}

void insertFully(const Geometry& geometry, PolygonWithLegs& whole, double u) {
  while (multiplicity(whole.polygon, u) < whole.polygon.degree) insertKnot(geometry, whole, u);
}

}  // namespace

int insertKnot(const Geometry& geometry, PolygonWithLegs& whole, double u) {
  ControlPolygon& polygon = whole.polygon;
  const ControlPolygon old = polygon;
  const int p = old.degree;
  const int n = old.points.count();
  const int first = insertKnot(geometry, polygon, u);
  if (old.closed && n < p) whole.legs.clear();
  if (whole.legs.empty()) return first;

  // The new points lie on the legs from first - 1 on, one point on each.
  const auto knot = [&](int j) { return knotOfSpan(old.knots, p, old.closed, j); };
  const int end = first + p - multiplicity(old, u);
  Array<SurfacePath> run;
  Array<LegAverage> averages;
  for (int i = first; i < end; ++i) {
    run.push_back(whole.legs[(i - 1) % n]);
    const double s = (u - knot(i - p)) / (knot(i) - knot(i - p));
    averages.push_back(averageOn(*geometry.mesh, run.back(),
                                 (1 - s) * old.points[(i - 1) % n].weight,
                                 s * old.points[i % n].weight));
    polygon.points[i % (n + 1)] = averages.back().point;
  }
  const Array<SurfacePath> renewed = legsOver(geometry, run, averages);
  Array<SurfacePath> legs(whole.legs.size() + 1);
  for (int i = 0; i < legs.count(); ++i) {
    // The legs of a closed curve are numbered from the new ones on.
    const int leg = old.closed && i < first - 1 ? i + n + 1 : i;
    const int place = leg - (first - 1);
    if (place < 0) {
      legs[i] = whole.legs[i];
    } else if (place < renewed.count()) {
      legs[i] = renewed[place];
    } else {
      legs[i] = whole.legs[(leg - 1) % n];
    }
  }
  whole.legs = std::move(legs);
  return first;
}

PolygonWithLegs partBefore(const Geometry& geometry, PolygonWithLegs open, double u) {
  insertFully(geometry, open, u);
  open.polygon = partBefore(geometry, std::move(open.polygon), u);
  if (!open.legs.empty()) open.legs.resize(open.polygon.points.size() - 1);
  return open;
}

PolygonWithLegs partAfter(const Geometry& geometry, PolygonWithLegs open, double u) {
  insertFully(geometry, open, u);
  const int before = open.polygon.points.count();
  open.polygon = partAfter(geometry, std::move(open.polygon), u);
  if (!open.legs.empty()) {
    open.legs.erase(open.legs.begin(), open.legs.begin() + before - open.polygon.points.count());
  }
  return open;
}

PolygonWithLegs cutOpen(const Geometry& geometry, PolygonWithLegs closed, double u) {
  insertFully(geometry, closed, u);
  const Array<double>& knots = closed.polygon.knots;
  const double start = u == knots.back() ? knots.front() : u;
  // The first leg is the one from the point at which the curve is cut.
  const auto beyond = std::upper_bound(knots.begin(), knots.end(), start);
  const int first = static_cast<int>(beyond - knots.begin()) - 1;
  closed.polygon = cutOpen(geometry, std::move(closed.polygon), u);
  if (!closed.legs.empty()) {
    std::rotate(closed.legs.begin(), closed.legs.begin() + first, closed.legs.end());
  }
  return closed;
}

LeggedPolygon elevated(const Geometry& geometry, const LeggedPolygon& bezier) {
  if (bezier.legs.empty()) return {elevated(geometry, bezier.points), {}};
  const int n = bezier.points.count();
  Array<LegAverage> averages;
  LeggedPolygon result;
  result.points.push_back(bezier.points.front());
  for (int i = 1; i < n; ++i) {
    const double share = static_cast<double>(i) / n;
    averages.push_back(averageOn(*geometry.mesh, bezier.legs[i - 1],
                                 share * bezier.points[i - 1].weight,
                                 (1 - share) * bezier.points[i].weight));
    result.points.push_back(averages.back().point);
  }
  result.points.push_back(bezier.points.back());
  result.legs = legsOver(geometry, bezier.legs, averages);
  return result;
}

void cutLeg(const Geometry& geometry, const SurfacePath& leg, double t, const SurfacePoint* cut,
            SurfacePath& before, SurfacePath& after) {
  const double at = t * leg.length();
  takePart(*geometry.mesh, leg, 0, at, before);
  takePart(*geometry.mesh, leg, at, leg.length(), after);
  if (!cut) return;
  StripWorkspace strip;
  if (!moveEnd(geometry, *cut, before, strip)) before = {};
  if (!moveStart(geometry, *cut, after, strip)) after = {};
}

}  // namespace karcher

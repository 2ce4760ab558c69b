#include "rcm/summed_field.h"

#include <memory>

#include "rcm/paper_method.h"
#include "rcm/point_field.h"

namespace karcher {
namespace {

/// Sums over all points, with a value for each vertex; 0 for unreachable vertices.
struct Sums {
  Array<double> squaredDistances;
  Array<Vec2> logVectors;  ///< the sums of -2 log
};

void addPoint(DistanceSolver& solver, const SurfacePoint& point, double weight, bool withVectors,
              Sums& sums) {
  solver.setSource(point);
  solver.grow(kInfinity);
  for (int v = 0; v < sums.squaredDistances.count(); ++v) {
    const double d = solver.distance(v);
    if (d == kInfinity) continue;
    sums.squaredDistances[v] += weight * d * d;
    if (withVectors) sums.logVectors[v] += weight * solver.logVector(v);
  }
}

/// Whether blends (FieldBlend) read the midpoint of an edge by its half-edge h, not by the twin of
/// h.
bool isAskedFor(const TriangleMesh& mesh, int h) { return h < mesh.twin[h]; }

/// The sum of fields with values at the midpoints of edges. The share of log vectors in an estimate
/// depends on the vectors, so the function estimates each field before it adds it.
ControlField sumOfEstimates(Surface& surface, const Array<SurfacePoint>& points,
                            const Array<double>& weights, const FieldOptions& options) {
  const TriangleMesh& mesh = surface.mesh();
  const auto values = std::make_shared<Array<FieldValue>>();
  const auto corrections = std::make_shared<Array<Vec2>>();
  values->resize(static_cast<size_t>(mesh.vertexCount()));
  corrections->assign(static_cast<size_t>(mesh.halfedgeCount()), Vec2::Zero());
  PointField point(surface, options);
  for (int i = 0; i < points.count(); ++i) {
    point.setPoint(points[i]);
    const int component = surface.component(mesh.corner(points[i].face, 0));
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (surface.component(v) != component) continue;
      const FieldValue& value = point.field().at(v);
      (*values)[v].gradient += weights[i] * value.gradient;
      (*values)[v].squaredDistance += weights[i] * value.squaredDistance;
    }
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      if (!isAskedFor(mesh, h) || surface.component(mesh.tail(h)) != component) continue;
      (*corrections)[h] += weights[i] * point.field().midpointCorrectionUnkept(h);
    }
  }
  ControlField field;
  field.reset([values](int v) { return (*values)[v]; },
              [corrections](int h) { return (*corrections)[h]; });
  return field;
}

}  // namespace

ControlField sumOfFields(Surface& surface, const Array<SurfacePoint>& points,
                         const Array<double>& weights, const FieldOptions& options) {
  const size_t count = static_cast<size_t>(surface.mesh().vertexCount());
  const bool paper = options.method == Method::kPaper;
  const Estimator estimator = estimatorOf(options.solver);
  if (!paper && !isLinear(estimator)) {
    return sumOfEstimates(surface, points, weights, options);
  }
  const auto sums = std::make_shared<Sums>();
  sums->squaredDistances.assign(count, 0);
  if (!paper) sums->logVectors.assign(count, Vec2::Zero());
  const std::unique_ptr<DistanceSolver> solver = makeDistanceSolver(surface, options);
  for (int i = 0; i < points.count(); ++i) {
    addPoint(*solver, points[i], weights[i], !paper, *sums);
  }

  if (paper) return fieldOfSquares(surface, options.star, std::move(sums->squaredDistances));
  ControlField field;
  field.reset([sums, &stencils = surface.stencils(estimator)](int v) {
    const double own = sums->squaredDistances[v];
    const Vec2 gradient = stencils.at(v).apply(
        own, [&](int u) { return sums->logVectors[u]; },
        [&](int u) { return sums->squaredDistances[u]; });
    return FieldValue{gradient, own};
  });
  return field;
}

}  // namespace karcher

#include "bindings/benchmark_handle.h"

#include <utility>

#include "bindings/field_options.h"
#include "distance/edge_dijkstra.h"

namespace karcher::bindings {

void BenchmarkHandle::prepare() const {
  Surface(buildMesh(mesh_.mesh().positions, mesh_.mesh().faces));
}

void BenchmarkHandle::edgeDijkstra() const { karcher::edgeDijkstra(mesh_.surface().geometry(), 0); }

void BenchmarkHandle::ringGraph(int rings) {
  Surface& surface = mesh_.surface();
  surface.takeRingGraph(rings, buildRingGraph(surface.geometry(), rings));
}

void BenchmarkHandle::field(const val& point, const val& options) {
  PointField field(mesh_.surface(), fieldOptionsFromJs(options));
  field.setPoint(pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
}

int BenchmarkHandle::chooseField(const val& point, const val& options, double radius) {
  field_.emplace(mesh_.surface(), fieldOptionsFromJs(options));
  field_->setPoint(pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
  within_ = verticesWithin(mesh_.surface(), *field_, radius);
  return within_.count();
}

void BenchmarkHandle::readField() {
  field_->setPoint(SurfacePoint(field_->point()));
  for (const int v : within_) field_->field().at(v);
}

void BenchmarkHandle::gradient() {
  const Array<double> values(mesh_.mesh().positions.size(), 1.0);
  applyGradient(mesh_.surface().gradientOperator(), values);
}

}  // namespace karcher::bindings

#include "peers/bindings/benchmark_handle.h"

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
  field_.emplace(mesh_.surface(), fieldOptionsFromJs(options),
                 pointFromJs(mesh_.numbering(), mesh_.mesh(), point), radius);
  return field_->vertexCount();
}

void BenchmarkHandle::readField() { field_->read(); }

void BenchmarkHandle::gradient() {
  const Array<double> values(mesh_.mesh().positions.size(), 1.0);
  applyGradient(mesh_.surface().gradientOperator(), values);
}

std::unique_ptr<BenchmarkHandle> makeBenchmark(MeshHandle& mesh) {
  return std::make_unique<BenchmarkHandle>(mesh);
}

}  // namespace karcher::bindings

#pragma once

#include <memory>
#include <optional>

#include "bindings/mesh_handle.h"
#include "peers/timed_field.h"

namespace karcher::bindings {

/// The steps that `karcher bench` times. Their times exclude the copies between JavaScript and the
/// engine that a binding adds. The mesh must outlive the object.
class BenchmarkHandle {
 public:
  explicit BenchmarkHandle(MeshHandle& mesh) : mesh_(mesh) {}

  /// Computes adjacency, lengths, angles and frames of the mesh, from its positions and faces.
  void prepare() const;
  /// Runs a plain Dijkstra search along edges, whose time shows the speed of the computer.
  void edgeDijkstra() const;
  /// Builds the graph of the paper's graph distances. The mesh keeps it.
  void ringGraph(int rings);
  void gradientOperator() { mesh_.surface().gradientOperator(); }
  /// Computes the paper's field of a point, including the gradients.
  void field(const val& point, const val& options);
  /// Chooses a field of log vectors and all vertices within `radius` of its point. Returns the
  /// number of these vertices.
  int chooseField(const val& point, const val& options, double radius);
  /// Computes the chosen field again, and reads its values at the chosen vertices.
  void readField();
  /// Applies the gradient operator once.
  void gradient();

 private:
  MeshHandle& mesh_;
  std::optional<TimedField> field_;
};

std::unique_ptr<BenchmarkHandle> makeBenchmark(MeshHandle& mesh);

}  // namespace karcher::bindings

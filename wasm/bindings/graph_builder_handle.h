#pragma once

#include "bindings/mesh_handle.h"
#include "distance/ring_graph.h"

namespace karcher::bindings {

/// The k-ring graph of a mesh, built in slices. The mesh must exist at each call except the
/// destructor.
class GraphBuilderHandle {
 public:
  GraphBuilderHandle(MeshHandle& mesh, int rings)
      : mesh_(mesh), rings_(rings), builder_(mesh.surface().geometry(), rings) {}

  /// Adds the next `vertices` vertices to the graph. Returns true when the graph is complete and
  /// belongs to the mesh.
  bool advance(int vertices) {
    if (!builder_.advance(vertices)) return false;
    mesh_.surface().takeRingGraph(rings_, builder_.take());
    return true;
  }
  double progress() const { return builder_.progress(); }

 private:
  MeshHandle& mesh_;
  int rings_;
  RingGraphBuilder builder_;
};

}  // namespace karcher::bindings

#pragma once

#include <map>
#include <memory>

#include "distance/ring_graph.h"
#include "intrinsic/geometry.h"
#include "rcm/estimators.h"
#include "rcm/gradient_operator.h"

namespace karcher {

/// A mesh with its derived data. The constructor computes the geometry; data that only some methods
/// need are computed on first use. A surface can be neither copied nor moved, since its parts point
/// to one another.
class Surface {
 public:
  explicit Surface(TriangleMesh mesh);
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const TriangleMesh& mesh() const { return mesh_; }
  const Geometry& geometry() const { return geometry_; }

  /// The number of a vertex's connected component.
  int component(int vertex);

  /// The graph of the paper's graph distances. The first use builds the graph unless
  /// `takeRingGraph` has provided it.
  const RingGraph& ringGraph(int rings);
  bool hasRingGraph(int rings) const { return ringGraphs_.count(rings) != 0; }
  /// Keeps a graph that a caller has built step by step (RingGraphBuilder).
  void takeRingGraph(int rings, RingGraph graph);

  const GradientOperator& gradientOperator(Star star = Star::kWide);

  /// The stencils of an estimator, each computed at its first read.
  StencilTable& stencils(Estimator estimator);

  /// Whether a vertex is a hub (hubs.h) or has an edge to one.
  bool isBesideHub(int vertex);

  /// The memory pool of the fields on the surface.
  const std::shared_ptr<PagePool>& pages() { return pages_; }

 private:
  TriangleMesh mesh_;
  Geometry geometry_;
  bool componentsAreKnown_ = false;
  Array<int> components_;  ///< empty if the mesh has one component
  bool hubsAreKnown_ = false;
  Array<char> isBesideHub_;  ///< the result of besideHubs
  std::map<int, RingGraph> ringGraphs_;
  std::map<Star, GradientOperator> gradientOperators_;
  std::map<Estimator, StencilTable> stencils_;
  std::shared_ptr<PagePool> pages_ = newPagePool();
};

/// Throws Error kUnreachable, naming two points by their indices in `points`, if the points do not
/// lie on one component.
void checkOneComponent(Surface& surface, const Array<SurfacePoint>& points);

}  // namespace karcher

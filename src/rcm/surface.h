#pragma once

#include <map>
#include <memory>

#include "distance/ring_graph.h"
#include "intrinsic/geometry.h"
#include "rcm/estimators.h"
#include "rcm/gradient_operator.h"

namespace karcher {

/// A mesh with what is derived from it. The geometry is made at once; what only some methods need
/// is made when it is first asked for. A surface is neither copied nor moved, since its parts point
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

  /// The graph of the paper's graph distances; built at once if `takeRingGraph` gave none.
  const RingGraph& ringGraph(int rings);
  bool hasRingGraph(int rings) const { return ringGraphs_.count(rings) != 0; }
  /// Keeps a graph that was built in slices.
  void takeRingGraph(int rings, RingGraph graph);

  const GradientOperator& gradientOperator(Star star = Star::kWide);

  /// The stencils of an estimator, made as they are read.
  StencilTable& stencils(Estimator estimator);

  /// Whether a vertex is a hub (hubs.h) or has an edge to one.
  bool isBesideHub(int vertex);

  /// The memory of the fields on the surface.
  const std::shared_ptr<PagePool>& pages() { return pages_; }

 private:
  TriangleMesh mesh_;
  Geometry geometry_;
  bool componentsAreKnown_ = false;
  Array<int> components_;  ///< empty where there is one
  bool hubsAreKnown_ = false;
  Array<char> isBesideHub_;  ///< see besideHubs
  std::map<int, RingGraph> ringGraphs_;
  std::map<Star, GradientOperator> gradientOperators_;
  std::map<Estimator, StencilTable> stencils_;
  std::shared_ptr<PagePool> pages_ = newPagePool();
};

/// Throws Error kUnreachable, naming the two points by their places in `points`, if the points do
/// not lie on one component.
void checkOneComponent(Surface& surface, const Array<SurfacePoint>& points);

}  // namespace karcher

#include "rcm/surface.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "rcm/hubs.h"

namespace karcher {

Surface::Surface(TriangleMesh mesh) : mesh_(std::move(mesh)), geometry_(buildGeometry(mesh_)) {}

int Surface::component(int vertex) {
  if (!componentsAreKnown_) {
    components_ = componentOfVertices(mesh_);
    componentsAreKnown_ = true;
    // A mesh with one component, like most meshes, needs no number for each vertex.
    const auto isFirst = [](int component) { return component == 0; };
    if (std::all_of(components_.begin(), components_.end(), isFirst)) components_ = {};
  }
  return components_.empty() ? 0 : components_[vertex];
}

bool Surface::isBesideHub(int vertex) {
  if (!hubsAreKnown_) {
    isBesideHub_ = besideHubs(mesh_);
    hubsAreKnown_ = true;
  }
  return !isBesideHub_.empty() && isBesideHub_[vertex] != 0;
}

const RingGraph& Surface::ringGraph(int rings) {
  const auto found = ringGraphs_.find(rings);
  if (found != ringGraphs_.end()) return found->second;
  return ringGraphs_.emplace(rings, buildRingGraph(geometry_, rings)).first->second;
}

void Surface::takeRingGraph(int rings, RingGraph graph) {
  ringGraphs_.insert_or_assign(rings, std::move(graph));
}

const GradientOperator& Surface::gradientOperator(Star star) {
  const auto found = gradientOperators_.find(star);
  if (found != gradientOperators_.end()) return found->second;
  return gradientOperators_.emplace(star, buildGradientOperator(geometry_, star)).first->second;
}

StencilTable& Surface::stencils(Estimator estimator) {
  const auto found = stencils_.find(estimator);
  if (found != stencils_.end()) return found->second;
  return stencils_.emplace(estimator, StencilTable(geometry_, estimator)).first->second;
}

void checkOneComponent(Surface& surface, const Array<SurfacePoint>& points) {
  const auto componentOf = [&](int i) {
    return surface.component(surface.mesh().corner(points[i].face, 0));
  };
  for (int i = 1; i < points.count(); ++i) {
    if (componentOf(i) == componentOf(0)) continue;
    throw Error(ErrorCode::kUnreachable,
                "points 0 and " + std::to_string(i) +
                    " lie on different components of the mesh; no path joins them");
  }
}

}  // namespace karcher

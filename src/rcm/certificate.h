#pragma once

#include "intrinsic/geometry.h"

/// The energy and the residual of a center of mass by exact shortest paths, however it was found.
///
/// Fields estimate the energy between vertices, each method in its own way, so that neither
/// energies nor gradients of two methods can be compared. These values can, since they depend on no
/// field.
namespace karcher {

struct Certificate {
  double energy = 0;    ///< sum_i w_i d(p, p_i)^2
  double residual = 0;  ///< |sum_i w_i log_p(p_i)|, a length: half of the energy's slope
};

/// The certificate of a point p for points p_i on its component. Weights are as for `centerOfMass`:
/// one for each point, divided by their sum if `normalize`. For a point inside a face (at least a
/// billionth of the face from its sides), the distances are those of one exact source, up to the
/// farthest point; on an edge or at a vertex, a shortest path to each point is found. The log
/// vectors at a vertex are those of its rescaled frame (tangent.h). Throws what WindowDistance
/// throws.
Certificate certificateOf(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Array<double> weights, bool normalize, const SurfacePoint& point);

}  // namespace karcher

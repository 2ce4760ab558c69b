#pragma once

#include "intrinsic/geometry.h"

/// The energy and the residual of a center of mass by exact shortest paths, whichever method found
/// it. Each method estimates the energy between vertices by fields of its own, so that the energies
/// and gradients of two methods are not comparable. The values of a certificate are comparable,
/// since they depend on no field.
namespace karcher {

struct Certificate {
  double energy = 0;    ///< sum_i w_i d(p, p_i)^2
  double residual = 0;  ///< |sum_i w_i log_p(p_i)|, a length: half the norm of the energy's
                        ///< gradient
};

/// The certificate of a point p for points p_i on its component. There is one weight for each
/// point; with `normalize` the weights are divided by their sum. If p lies inside a face, the exact
/// solver computes the distances from p up to the farthest p_i, after it has moved p to weights of
/// at least 1e-9. If p lies on an edge or at a vertex, the distances are the lengths of shortest
/// paths. The log vectors at a vertex are those of its rescaled frame (tangent.h). Throws what
/// WindowDistance throws.
Certificate certificateOf(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Array<double> weights, bool normalize, const SurfacePoint& point);

}  // namespace karcher

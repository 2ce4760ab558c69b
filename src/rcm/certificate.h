#pragma once

#include "intrinsic/geometry.h"

/// The energy and the residual of a center of mass by exact shortest paths. Each method estimates
/// the energy between vertices by fields of its own, so that the energies and gradients of two
/// methods are not comparable. The values of a certificate depend on no field, so that they are
/// comparable for centers from different methods.
namespace karcher {

struct Certificate {
  double energy = 0;    ///< sum_i w_i d(p, p_i)^2
  double residual = 0;  ///< |sum_i w_i log_p(p_i)|, a length: half the norm of the energy's
                        ///< gradient
};

/// The certificate of a point p for points p_i on its component. There is one weight for each
/// point; with `normalize` the weights are divided by their sum. If p lies inside a face, the exact
/// solver computes the distances from p up to the farthest p_i. It first moves p inwards if a
/// weight of p is below 1e-9. If p lies on an edge or at a vertex, the distances are the lengths of
/// shortest paths. Log vectors at a vertex belong to its rescaled frame (tangent.h). Throws
/// what WindowDistance throws.
Certificate certificateOf(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Array<double> weights, bool normalize, const SurfacePoint& point);

}  // namespace karcher

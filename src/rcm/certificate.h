#pragma once

#include "intrinsic/geometry.h"

/// What a center of mass is worth by exact shortest paths, however it was found.
///
/// Fields estimate the energy between vertices, each method in its own way, so that energies of two
/// methods cannot be compared, nor can the gradients that their searches bring to zero. What is
/// measured here can: it asks no field.
namespace karcher {

struct Certificate {
  double energy = 0;    ///< sum_i w_i d(p, p_i)^2
  double residual = 0;  ///< |sum_i w_i log_p(p_i)|, a length: half of the energy's slope
};

/// Of a point p with points p_i on its component and weights as `centerOfMass` takes them: one a
/// point, to be divided by their sum or not. Inside a face it takes the exact distances of one
/// source, as far as the farthest point (from a billionth of the face inside of its sides); on an
/// edge or at a vertex a shortest path to each point. The log vectors at a vertex are those of its
/// rescaled frame (tangent.h).
/// Throws what WindowDistance throws.
Certificate certificateOf(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Array<double> weights, bool normalize, const SurfacePoint& point);

}  // namespace karcher

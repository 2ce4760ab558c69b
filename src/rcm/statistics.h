#pragma once

#include <optional>

#include "rcm/field_blend.h"
#include "rcm/field_set.h"

/// Robust means, and derivatives of the energy sum_i w_i d(x, p_i)^2, by shortest paths. The
/// package `karcher/statistics` has the same functions under the same names.
namespace karcher {

/// The start and the end of a search for a robust mean.
struct RobustOptions {
  std::optional<SurfacePoint> start;  ///< the start; by default the center of mass
  /// the search ends after a step shorter than this, relative to the diagonal
  double tolerance = 1e-7;
  int mostSteps = 200;
};

struct RobustMean {
  SurfacePoint point;
  double value = 0;  ///< the sum that the mean minimizes
  int steps = 0;
  /// Whether the last step was shorter than the tolerance, or the median is one of the points.
  bool converged = false;
};

/// The geometric median: the minimum of the weighted sum of distances to points. It stays near the
/// majority if less than half of the points lie elsewhere. The search finds the minimum near its
/// start. Each step leads to the center of mass with weights divided by the distances, and takes
/// one exact search of distances. (E. Weiszfeld, "Sur le point pour lequel la somme des distances
/// de n points donnes est minimum", 1937; P. T. Fletcher, S. Venkatasubramanian, S. Joshi, "The
/// geometric median on Riemannian manifolds", 2009.) The step at which a point is the nearest for
/// the first time tests the point: it is a local median if in no direction the pull of the points
/// elsewhere is more than the weight of all points at its place. If the sum is no larger there than
/// at the end of the last step, the search ends there, or else goes beyond a point that is no local
/// median. (Y. Vardi, C.-H. Zhang, "The multivariate L1-median and associated data depth", 2000.)
/// Throws what `centerOfMass` throws (mean.h), and Error kBadArgument unless there is one positive
/// weight for each point.
RobustMean median(FieldSets& sets, const Array<SurfacePoint>& points, const Array<double>& weights,
                  const RobustOptions& options = {});

/// The Huber mean: the minimum of the weighted sum of the points' costs. The cost of a point at the
/// distance d is d^2 / 2 up to a threshold t, and t (d - t / 2) beyond. So points beyond the
/// threshold pull no more than points at it (P. J. Huber, "Robust Estimation of a Location
/// Parameter", 1964). Throws what `median` throws, and Error kBadArgument for a threshold that is
/// not positive.
RobustMean huberMean(FieldSets& sets, const Array<SurfacePoint>& points,
                     const Array<double>& weights, double threshold,
                     const RobustOptions& options = {});

/// The energy at a place, and its gradient in the tangent plane there (tangent.h).
struct EnergyGradient {
  double energy = 0;
  Vec2 gradient = Vec2::Zero();  ///< the gradient: -2 times the weighted sum of the log vectors
};

/// The energy and its gradient by the paths of the log map (tangent_maps.h). The gradient belongs
/// to the polyhedron itself. At a center of mass this gradient is small but not zero, since
/// searches for centers use fields that smooth these paths. Throws Error kUnreachable as the log
/// map does.
EnergyGradient energyAt(const Geometry& geometry, const Array<SurfacePoint>& points,
                        Weights weights, const SurfacePoint& place);

/// The second derivatives of the energy at a place inside a face, along the axes of the face's
/// frame. The function computes them from the differences of gradients at places on opposite sides
/// of the given place. On a plane the Hessian is twice the sum of the weights times the identity.
/// It does not exist at a place from which several shortest paths lead to one of the points. Throws
/// as above, and Error kBadArgument for a place on an edge or at a vertex.
Eigen::Matrix2d hessianAt(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Weights weights, const SurfacePoint& place);

/// The partial derivatives of the center of mass with respect to the weights. They are vectors in
/// the frame of the center's face. Like the gradient, they belong to the polyhedron, not to a
/// smooth surface. The center must lie inside a face. Throws what `hessianAt` throws, and Error
/// kBadArgument where the Hessian is not positive definite.
Array<Vec2> weightDerivatives(const Geometry& geometry, const Array<SurfacePoint>& points,
                              Weights weights, const SurfacePoint& center);

/// The derivatives of the center of mass with respect to each point: a matrix that maps vectors in
/// the frame of the point's face to vectors in the frame of the center's face. The Hessian times
/// this matrix is twice the point's weight times the derivative of the point's log vector at the
/// center, which the function computes by finite differences. If the path passes through no vertex,
/// the derivative of the log vector equals the parallel transport along the path. The center and
/// the points must lie inside faces. Throws what `weightDerivatives` throws.
Array<Eigen::Matrix2d> pointDerivatives(const Geometry& geometry, const Array<SurfacePoint>& points,
                                        Weights weights, const SurfacePoint& center);

}  // namespace karcher

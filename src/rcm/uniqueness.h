#pragma once

#include <optional>

#include "mesh/shapes.h"
#include "rcm/surface.h"

/// Uniqueness of centers of mass. Suppose that the points lie in a ball that is small compared with
/// the curvature and the injectivity radius. Then the energy is convex in the ball. It has only one
/// minimum there, and no lower value outside (H. Karcher, "Riemannian Center of Mass and Mollifier
/// Smoothing", 1977).
///
/// On a mesh the same is true for a ball of any size if it lies in a disk without a vertex of
/// positive curvature. Such a disk has unique shortest paths and convex squared distances (M.
/// Bridson, A. Haefliger, "Metric Spaces of Non-Positive Curvature", chapter II.4; R. Bishop, "The
/// Intrinsic Geometry of a Jordan Domain", for the boundary of the disk).
namespace karcher {

/// The knowledge about other minima of the energy.
enum class Uniqueness {
  kNotLooked,  ///< no searches started all over the surface
  kCertain,    ///< a proof shows that no other minimum is lower or near the points
  kLikely,     ///< all searches ended at this minimum
  kNotUnique,  ///< some searches ended at other minima
};

/// The name of a state in reports: "notLooked".
const char* uniquenessName(Uniqueness uniqueness);

/// Bounds of the smooth surface that a mesh approximates.
struct CurvatureBound {
  double largestCurvature = 0;  ///< the largest Gaussian curvature
  double injectivityRadius =
      0;  ///< the length up to which every geodesic is the unique shortest path
};

/// The bound of the sphere and the torus, whose curvature has a closed form.
std::optional<CurvatureBound> curvatureBound(Shape shape);

/// The radius of a ball about `center` that holds all points of nonzero weight; -1 without a proof.
/// The proof shows that the energy has no other minimum in the ball and no lower value elsewhere.
/// With negative weights there is no proof. With `smooth` the proof may be for the smooth surface
/// that the mesh approximates. Otherwise it is for the mesh; then no vertex within three radii of
/// the center has an angle defect above 1e-9.
double provedRadius(const Surface& surface, const Array<SurfacePoint>& points,
                    const Array<double>& weights, const SurfacePoint& center,
                    const std::optional<CurvatureBound>& smooth = std::nullopt);

/// Points spread evenly over the connected component of a face: the centroids of at most `count`
/// faces. The function sums the faces' areas in order, divides the sum into `count` equal steps,
/// and takes the face at the middle of each step. Faces near in this order are near in space.
Array<SurfacePoint> spreadPoints(Surface& surface, int face, int count);

}  // namespace karcher

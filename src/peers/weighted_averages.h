#pragma once

#include "peers/embedding.h"
#include "rcm/field_blend.h"
#include "rcm/search_end.h"

/// Weighted averages on surfaces: D. Panozzo, I. Baran, O. Diamanti, O. Sorkine-Hornung, "Weighted
/// Averages on Surfaces", ACM Transactions on Graphics 32 (2013). The mesh is embedded in eight
/// dimensions, where straight distances approximate geodesic ones (embedding.h). There the averages
/// are linear, and Phong projection (phong_projection.h) returns them to the surface. After the
/// preparation, an average takes microseconds. So does the inverse problem: the weights for which a
/// point is the average.
namespace karcher {

class WeightedAverages {
 public:
  /// The mesh must outlive the averages.
  WeightedAverages(const TriangleMesh& mesh, Embedding embedding);

  /// The forward problem (section 4). The weights should sum to 1. The status is kNoProgress if the
  /// average has no projection, for example beyond the boundary. Throws Error kBadWeights if there
  /// is not one weight for each point.
  SearchEnd centerOfMass(const Array<SurfacePoint>& points, Weights weights,
                         const SurfacePoint& start) const;

  /// The inverse problem (section 5): weights, summing to 1, whose average projects to `target`. Of
  /// all such weights w_i, these minimize the sum of (w_i d_i^2)^2. Here d_i^2 is the squared
  /// distance of point i from the target, in which the square of the component normal to the
  /// tangent plane counts tenfold. Throws Error: kTooFewPoints (fewer than 3), kBadArgument if the
  /// points lie on one line as seen from the target.
  Array<double> weightsOf(const Array<SurfacePoint>& points, const SurfacePoint& target) const;

 private:
  PhongSurface surface_;
};

}  // namespace karcher

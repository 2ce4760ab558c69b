#pragma once

#include "distance/paged_array.h"
#include "intrinsic/geometry.h"

/// Estimators of the gradient of a squared distance at a vertex. An estimate is a linear
/// combination of a solver's values around the vertex. The coefficients depend only on the mesh, so
/// that all fields share them.
///
/// A fit places the neighbours in the plane of the vertex's frame by transport along edges. The
/// neighbours' weights are a Gaussian with the covariance of their places, so that anisotropy of
/// the mesh does not change the weights.
///
/// Where triangles approximate a smooth surface, a fit averages out the noise of single vectors. On
/// a rough surface such as a scan, shortest paths prefer one side of a vertex, and a fit mistakes
/// this preference for noise. So the vertex's own log vector replaces a share of the fit (Stencil).
/// The share is larger where angle defects vary more from vertex to vertex.
namespace karcher {

enum class Estimator {
  /// A linear least-squares fit to the log vectors of the 1-ring, transported into the vertex's
  /// frame; the estimate is the fit's value at the vertex. It is exact for linear fields, such as
  /// fields on the plane, and has half the noise of single vectors.
  kLinear1,
  /// the same fit over the 2-ring
  kLinear2,
  /// A quadratic least-squares fit to squared distances over the 2-ring, through the vertex's own
  /// value; the estimate is the fit's gradient at the vertex. It is of second order, and needs
  /// exact log vectors. The share of the vertex's own log vector also depends on the field
  /// (shareOfLogVector). If the ring does not determine the fit, kLinear2 gives the estimate.
  kQuadratic2,
};

/// Whether estimates are linear in a solver's values, so that the estimate of a sum of fields is
/// the sum of their estimates.
inline bool isLinear(Estimator estimator) { return estimator != Estimator::kQuadratic2; }

/// A term of a stencil. A term of vectors is the neighbour's vector times (x, y) as a complex
/// number. A term of distances is the vector (x, y) times a difference: the neighbour's squared
/// distance minus the vertex's squared distance.
struct StencilTerm {
  /// x and y are two numbers, since with an aligned Vec2 a term would take a third more memory.
  double x;
  double y;
  int vertex;
};

/// An estimate: (1 - r) times the fit plus r times the vertex's own log vector. The share r is s^2
/// / (s^2 + m^2 + 0.003^2). Here m is the mean and s the standard deviation of angle defects (in
/// radians): of the vertex and of its neighbours, except vertices on the boundary. At a hub (a
/// vertex with more than 64 edges) r is 1.
struct Stencil {
  const StencilTerm* begin = nullptr;  ///< the first of the terms of log vectors
  const StencilTerm* ofDistances = nullptr;
  const StencilTerm* end = nullptr;
  double logVectorShare = 0;  ///< the share r

  /// The estimate from log vectors and squared distances. Both are given as functions of the
  /// vertex.
  template <class LogVectorAt, class SquaredDistanceAt>
  Vec2 apply(double ownSquaredDistance, const LogVectorAt& logVectorAt,
             const SquaredDistanceAt& squaredDistanceAt) const {
    double x = 0;
    double y = 0;
    for (const StencilTerm* term = begin; term != ofDistances; ++term) {
      const Vec2& vector = logVectorAt(term->vertex);
      x += term->x * vector.x() - term->y * vector.y();
      y += term->y * vector.x() + term->x * vector.y();
    }
    for (const StencilTerm* term = ofDistances; term != end; ++term) {
      const double difference = squaredDistanceAt(term->vertex) - ownSquaredDistance;
      x += difference * term->x;
      y += difference * term->y;
    }
    return {x, y};
  }
};

/// The share of the log vector in an estimate. It is at least `share`, which depends only on the
/// mesh. `difference` is the gradient by the log vector minus the gradient by the fit. Its length
/// divided by twice `distance`, the distance from the source, is an angle at the source. If this
/// angle is larger than on smooth surfaces, paths arrive from both sides of a ridge. A fit over
/// both sides then describes no path, so the share grows.
inline double shareOfLogVector(double share, const Vec2& difference, double distance) {
  constexpr double kAngle = 0.01;  // an angle in radians
  const double squaredAngle = difference.squaredNorm() / (4 * distance * distance);
  if (!(squaredAngle > 0)) return share;
  const double relative = kAngle * kAngle / squaredAngle;
  return share + (1 - share) / (1 + relative * relative);
}

/// A neighbour, placed in the plane of a vertex's frame.
struct StencilNeighbour {
  int vertex;
  Vec2 place;
  Vec2 rotation;  ///< a unit vector: the turn from the neighbour's frame into the vertex's
};

/// The stencils of one estimator, each computed on first use.
class StencilTable {
 public:
  /// The geometry must outlive the table.
  StencilTable(const Geometry& geometry, Estimator estimator);

  /// The stencil of a vertex; valid until the next call.
  Stencil at(int vertex);

 private:
  struct Place {
    int64_t begin = -1;
    int ofVectors = 0;
    int count = 0;
    double logVectorShare = 0;
  };

  const Geometry& geometry_;
  Estimator estimator_;
  PagedArray<Place, 8> places_;
  Array<StencilTerm> terms_;
  Array<StencilNeighbour> ring_;  ///< scratch memory
  Array<int> ways_;
};

}  // namespace karcher

#pragma once

#include "distance/paged_array.h"
#include "intrinsic/geometry.h"

/// Estimators of the gradient of a squared distance at a vertex, as linear combinations of what a
/// solver found around it. Their coefficients depend on the mesh alone, so they serve all fields.
///
/// Neighbours are placed in the plane of the vertex's frame along edges, and weighted by a Gaussian
/// of the covariance of their places, which makes the weights blind to a mesh's stretch.
///
/// A fit averages the noise of single vectors away where triangles stand for a smooth surface. On a
/// rough one, as a scan, paths keep to the sides of vertices where they are shortest, which a fit
/// takes for noise. So the vertex's own log vector takes the fit's place by degrees, as angle
/// defects vary from vertex to vertex (Stencil).
namespace karcher {

enum class Estimator {
  /// Linear least-squares fit of the log vectors of the 1-ring, carried into the vertex's frame:
  /// its value at the vertex. Exact for fields that are linear, as on the plane; halves the noise
  /// of single vectors.
  kLinear1,
  /// The same over the 2-ring.
  kLinear2,
  /// Quadratic least-squares fit of squared distances over the 2-ring, through the vertex's own
  /// value: its gradient there. Second order; kLinear2 where the ring does not determine the fit.
  /// For log vectors that are exact: how much of the fit they replace depends on the field as well
  /// (shareOfLogVector).
  kQuadratic2,
};

/// Whether estimates are linear in what a solver found, so that the estimate of a sum of fields is
/// the sum of their estimates.
inline bool isLinear(Estimator estimator) { return estimator != Estimator::kQuadratic2; }

/// A term of a stencil. A term of vectors is the neighbour's vector times (x, y) as a complex
/// number. A term of distances is the neighbour's squared distance less that of the vertex, times
/// the vector (x, y).
struct StencilTerm {
  /// Two numbers: a Vec2 would be aligned, and take a third more memory.
  double x;
  double y;
  int vertex;
};

/// (1 - r) times the fit plus r times the vertex's own log vector: r = s^2 / (s^2 + m^2 + 0.003^2),
/// with m the mean and s the standard deviation of the angle defects, in radians, of the vertex and
/// its neighbours. At a hub, a vertex of more than 64 edges, r is 1.
struct Stencil {
  const StencilTerm* begin = nullptr;  ///< terms of log vectors
  const StencilTerm* ofDistances = nullptr;
  const StencilTerm* end = nullptr;
  double logVectorShare = 0;  ///< r

  /// The estimate from log vectors and squared distances, both functions of the vertex.
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

/// The part of the log vector itself in an estimate, whose part by the mesh alone is `share`.
/// `difference` is the log vector less what else would stand there. Seen from the source, at
/// `distance`, it makes an angle. If the angle is more than smooth surfaces leave between
/// neighbours, paths come from both sides of a ridge, and no fit over both is any path's.
inline double shareOfLogVector(double share, const Vec2& difference, double distance) {
  constexpr double kAngle = 0.01;  // radians
  const double squaredAngle = difference.squaredNorm() / (4 * distance * distance);
  if (!(squaredAngle > 0)) return share;
  const double relative = kAngle * kAngle / squaredAngle;
  return share + (1 - share) / (1 + relative * relative);
}

/// A neighbour, placed in the plane of a vertex's frame.
struct StencilNeighbour {
  int vertex;
  Vec2 place;
  Vec2 rotation;  ///< unit: turns vectors in the neighbour's frame into the vertex's
};

/// The stencils of one estimator, each made when it is first asked for.
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
  Array<StencilNeighbour> ring_;  ///< scratch
  Array<int> ways_;
};

}  // namespace karcher

#pragma once

#include "distance/source_vectors.h"
#include "distance/window_distance.h"
#include "intrinsic/straightest.h"

/// The energy K(p) = sum_i w_i d(p, p_i)^2 of many points at few places. Distances are symmetric,
/// so one search with the place as its only source gives all distances. Half of -grad K is the
/// weighted sum of the log vectors at the place. Thousands of points take as much work as one.
namespace karcher {

/// Points with nonzero weights, sorted by their faces. Equal points are merged. So K does not
/// depend on the points' order, not even in its last bit.
struct WeightedPoints {
  Array<SurfacePoint> points;
  Array<double> weights;
};
WeightedPoints mergedPoints(const Array<SurfacePoint>& points, const Array<double>& weights);

/// K at a place, and the natural step sum_i w_i log(p_i) = -grad K / 2.
struct EnergyAt {
  double energy = 0;
  Vec2 step = Vec2::Zero();  ///< the natural step in the frame of the place's face
};

class OneSourceEnergy {
 public:
  /// The points must lie on one component. The arguments must outlive the object. The solver must
  /// implement DistanceSolver::stepTo.
  OneSourceEnergy(const Geometry& geometry, const WeightedPoints& points, DistanceSolver& solver);

  /// K and the natural step. Both use the solver's distances, interpolated in the points' faces,
  /// and are exact on a plane.
  EnergyAt at(const SurfacePoint& place);

  /// The number of times that the energy computed distances.
  int solved() const { return solved_; }

 private:
  const Geometry& geometry_;
  const WeightedPoints& points_;
  DistanceSolver& solver_;
  SourceVectors vectors_;
  int solved_ = 0;
};

/// K by exact distances to the points themselves. The natural step is exact, too: it follows from
/// the directions in which shortest paths leave the place.
class ExactOneSourceEnergy {
 public:
  /// The conditions are those of OneSourceEnergy. Throws what WindowDistance throws.
  ExactOneSourceEnergy(const Geometry& geometry, const WeightedPoints& points);

  EnergyAt at(const SurfacePoint& place);
  double energyAt(const SurfacePoint& place);

  int solved() const { return solved_; }

 private:
  /// The last straight part of a path to a point.
  struct Way {
    double length = kInfinity;  ///< the length of the whole path
    Vec2 toSource = Vec2::Zero();
    /// the vertex at which the last part begins, or -1 if it begins at the source
    int pseudoSource = -1;
  };

  void grow(const SurfacePoint& place);
  void measure();
  Vec2 directionTo(int vertex);
  Vec2 directionBefore(const StraightestPath& back) const;

  const Geometry& geometry_;
  const WeightedPoints& points_;
  WindowDistance solver_;
  Array<Way> ways_;         ///< the ways, one for each point
  Array<Vec2> directions_;  ///< the directions in which shortest paths to the ways' pseudosources
                            ///< leave the source
  int solved_ = 0;
};

}  // namespace karcher

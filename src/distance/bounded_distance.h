#pragma once

#include <memory>
#include <utility>

#include "distance/distance_solver.h"
#include "distance/exact_distance.h"
#include "distance/fast_distance.h"

/// Approximate geodesic distances that are held to real paths.
///
/// The fast solver's values (fast_distance.h) are taken as they are up to the first one that does
/// not stand the test, and exact ones (exact_distance.h) from there on. The test is a path of the
/// surface to each vertex. It is found by unfolding the faces behind the vertex in the direction in
/// which its path arrives: each vertex of that strip in sight has a path already, and so has the
/// source. Its length bounds the exact distance from above, whatever the mesh; where it is longer
/// than the value by more than the tolerance, the value may be too short. What is too long is found
/// where paths from different sides meet: a strip in the direction of a neighbour's path shows a
/// shorter way, which takes the value's place. That is no bound, but with the nearest vertices held
/// to exact distances it catches all that was seen (`npm run study -- fields`).
///
/// Fields do not use it yet: the fast solver still does what a trial of the mesh (fast_trial.h)
/// lets it.
namespace karcher {

class BoundedDistance final : public DistanceSolver {
 public:
  /// The part of a distance by which a value may be off.
  static constexpr double kTolerance = 0.01;

  /// The geometry must outlive the solver, as in FastDistance. A tolerance of 0 gives exact
  /// distances wherever the fast solver's are.
  explicit BoundedDistance(const Geometry& geometry,
                           std::shared_ptr<const VertexFans> fans = nullptr,
                           const std::shared_ptr<PagePool>& pages = newPagePool(),
                           double tolerance = kTolerance);

  void setSource(const SurfacePoint& source) override;
  void grow(double radius) override;
  double growTo(int vertex) override;
  double reached() const override { return isExactOn_ ? exact_->reached() : kShortest * checked_; }
  bool isFinal(int vertex) const override {
    return isFast(vertex) ? fast_.distance(vertex) <= checked_
                          : isExactOn_ && exact_->isFinal(vertex);
  }
  double distance(int vertex) const override {
    if (!isFast(vertex)) return exact_->distance(vertex);
    const Path* path = paths_.find(vertex);
    return path != nullptr && path->isShorter ? path->length : fast_.distance(vertex);
  }
  Vec2 logVector(int vertex) const override;
  PathStep stepTo(int vertex) const override { return solverOf(vertex).stepTo(vertex); }

  /// Values from here on are exact; kInfinity while all that was looked at stood the test.
  double trusted() const { return trusted_; }

  /// The length of the path to a vertex that was found in the test: no less than its distance.
  double pathLength(int vertex) const {
    const Path* path = paths_.find(vertex);
    return path == nullptr ? kInfinity : path->length;
  }

 private:
  /// A value that is too long by more than this is not mended.
  static constexpr double kShortest = 0.98;

  struct Path {
    double length = kInfinity;
    double direction = 0;    ///< in which it leaves the vertex, unscaled (geometry.h)
    bool isShorter = false;  ///< it takes the value's place
  };
  /// The faces unfolded behind a vertex, which is the origin.
  struct Strip {
    int halfedge;  ///< the last edge, from `tail` on the right to `head` on the left
    Vec2 tail;
    Vec2 head;
    Vec2 along;    ///< the direction in which faces are unfolded
    double right;  ///< unscaled direction at the vertex of the x axis
  };

  bool isFast(int vertex) const { return !isExactOn_ || fast_.distance(vertex) < trusted_; }
  const DistanceSolver& solverOf(int vertex) const {
    if (isFast(vertex)) return fast_;
    return *exact_;
  }
  void check();
  bool stands(int vertex, double value);
  Path ownPath(int vertex, double value) const;
  Path pathAlong(Strip strip, double value, double enough, int mostFaces) const;
  Path pathTowards(int vertex, double direction, double value, double enough, int mostFaces) const;
  double lengthVia(int vertex, double value, double leg) const;
  void goOnExactly(double from);

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  double tolerance_;
  SurfacePoint source_;
  Array<SurfacePoint> sources_;  ///< the source, in each of the faces it lies in
  FastDistance fast_;
  std::unique_ptr<ExactDistance> exact_;  ///< made when it is first needed
  bool isExactOn_ = false;
  double trusted_ = kInfinity;
  double checked_ = -1;  ///< all of the fast solver's values up to this one were looked at
  PagedArray<Path, 4> paths_;
  int nearLeft_ = 0;    ///< so many more vertices are held to exact distances
  Array<int> waiting_;  ///< vertices that were settled but not yet looked at
  Array<std::pair<double, int>> batch_;
};

}  // namespace karcher

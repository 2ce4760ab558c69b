#pragma once

#include <memory>
#include <string>

#include "bindings/mesh_handle.h"
#include "peers/compared_curve.h"

namespace karcher::bindings {

/// A method of the comparison, prepared on a mesh that must outlive it.
class PreparedMethodHandle {
 public:
  PreparedMethodHandle(MeshHandle& mesh, const ComparedOptions& options)
      : mesh_(mesh), method_(mesh.surface(), options) {}

  MeshHandle& mesh() { return mesh_; }
  PreparedMethod& method() { return method_; }

 private:
  MeshHandle& mesh_;
  PreparedMethod method_;
};

/// A curve by a prepared method. The mesh and the method must outlive it.
class ComparedCurveHandle {
 public:
  ComparedCurveHandle(PreparedMethodHandle& method, ComparedPlan plan)
      : mesh_(method.mesh()), curve_(method.method(), std::move(plan)) {}

  void movePoint(int i, const val& point);
  void startAt(const val& point);
  bool advance(int samples) { return curve_.advance(samples); }
  int samplesLeft() const { return curve_.samplesLeft(); }
  int lostByOwnRule() const { return curve_.lostByOwnRule(); }
  /// {made, asked, ms}: the number of computed log maps, the number of requests for log maps, and
  /// the milliseconds that the computation took; null for methods without log maps.
  val logMaps() const;
  /// The view (view.h) of the samples alone.
  val samples() const;
  /// The view of the path: the samples of each segment, joined by geodesics.
  val joined() const;

 private:
  MeshHandle& mesh_;
  ComparedCurve curve_;
};

/// `options` is {method, field: {method, solver, rings, star}, seeds, delaunay, adaptive,
/// landmarks, landmarkDistances}. `progress` is undefined, or a function that takes the number of
/// landmarks and returns whether to continue.
std::unique_ptr<PreparedMethodHandle> prepareMethod(MeshHandle& mesh, const val& options,
                                                    const val& progress);

/// `first` is an Int32Array of the segments' first points. `weights` is a Float64Array with a row
/// for each of the parameters `t`; a row has a weight for each point of a segment.
std::unique_ptr<ComparedCurveHandle> comparedCurve(PreparedMethodHandle& method, const val& points,
                                                   const val& first, const val& t,
                                                   const val& weights);

/// {points, t, weights} of the basis `name` at evenly spaced t. The names and their `parameters`
/// are 'bspline' (uniform cubic; none), 'bezier' (the degree), 'rational' (the points' weights, on
/// Bernstein polynomials) and 'barycentric' (the betas).
val basisWeights(const std::string& name, const val& parameters, int samples);

}  // namespace karcher::bindings

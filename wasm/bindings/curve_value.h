#pragma once

#include "bindings/mesh_handle.h"
#include "curves/curve.h"
#include "curves/refine/refine.h"

namespace karcher::bindings {

/// Conversion of a control polygon's legs. In JavaScript, legs are a list with an array for each
/// leg: the points through which the leg passes, or no points for a shortest leg. The list is empty
/// if all legs are shortest.
class Legs {
 public:
  /// The legs of a curve's value with these points. `areDrawn`, an Int32Array of 0 and 1, marks
  /// drawn legs. The points of a drawn leg include its ends, which may differ from the control
  /// points. Legs that are the same as in the last call need no new search. Throws Error
  /// kUnreachable if the points of a leg and its ends lie on different components, and what
  /// `pointsFromJs` throws.
  Array<SurfacePath> fromJs(const MeshHandle& mesh, const Array<SurfacePoint>& points,
                            const val& legs, const val& areDrawn);

 private:
  struct Leg {
    SurfacePoint from;
    SurfacePoint to;
    Array<SurfacePoint> waypoints;
    SurfacePath path;
  };

  Array<Leg> known_;
};

CurveKind curveKind(const std::string& name);

/// Reads {points, legs, areDrawn, shape, sampling, field}. `points` is a Float64Array with one
/// point after the other; `legs` and `areDrawn` are as in Legs::fromJs. `shape` is {kind, closed,
/// degree, clamped, knots, weights, betas, centripetal, basis}; `knots`, `weights` and `betas` are
/// Float64Arrays, empty if unused; `basis` is undefined, or a function that takes the number of
/// points and t and returns a Float64Array. `sampling` is {samples, tolerance, exact, levels,
/// leastLevels, levelsTolerance}, and `field` is an argument for `fieldOptionsFromJs`.
CurveValue curveValueFromJs(const MeshHandle& mesh, const val& value, Legs& legs);

/// An object with `points` and the properties of the shape, without the basis.
val toJs(const MeshHandle& mesh, const CurveParts& parts);

/// A list with {path, shorter} for each leg of a curve. `path` is the leg's path (path.h).
/// `shorter` is a shorter path between the leg's ends; it is missing for shortest legs, and if a
/// search finds no shorter path.
val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve);

}  // namespace karcher::bindings

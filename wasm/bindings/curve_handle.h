#pragma once

#include <optional>
#include <string>

#include "bindings/curve_value.h"
#include "bindings/view.h"
#include "curves/query/measure.h"

namespace karcher::bindings {

/// A curve that JavaScript owns. The mesh must outlive it.
class CurveHandle {
 public:
  /// `value` is an argument for `curveValueFromJs`.
  CurveHandle(MeshHandle& mesh, const val& value);

  /// Sets the curve to a value and returns its view (view.h); `options` is {inDouble, withPoints}.
  val set(const val& value, const val& options);
  val view(const val& options) const;
  /// The curve's value (curve_value.h): {points, legs} and the properties of its shape.
  val value() const;
  /// The legs, as `legsAndShorterToJs` of curve_value.h returns them.
  val legs() { return legsAndShorterToJs(mesh_, curve_); }

  /// Makes the edit of this name, and sets what `EngineCurveEdits` of karcher-engine.d.mts says.
  /// Returns the number of the point that it inserted on the curve, else `i`.
  int edit(const std::string& name, int i, const val& to);
  /// Splits the curve at a parameter and returns a list of its parts' values.
  val splitAt(double parameter);
  val joined(const CurveHandle& other);

  int pointCount() const { return curve_.pointCount(); }
  int fieldsComputed() const { return curve_.fieldsMade(); }
  double deviation() { return curve_.deviation(); }

  /// {parameter, point, position, status}
  val pointAt(double parameter);
  /// {parameter, point, position, status, inFace, inSpace}
  val tangentAt(double parameter);
  /// {parameter, point, position, status, distance}; `place` is a Float64Array of three numbers.
  val nearest(const val& place);
  double lengthAt(double parameter);
  val pointAtLength(double length);
  /// {parameter, face, bary, position}: arrays with an entry for each point.
  val equallySpaced(int count);

 private:
  int insertOnCurve(double parameter);
  void become(CurveValue value);
  const CurveLine& line();
  val curvePointToJs(const CurvePoint& at) const;

  MeshHandle& mesh_;
  Legs legs_;
  Curve curve_;
  std::optional<CurveLine> line_;
};

}  // namespace karcher::bindings

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
  /// The legs, as `legsAndShorterToJs` of legs.h returns them.
  val legs() { return legsAndShorterToJs(mesh_, curve_); }

  void movePoint(int i, const val& point);
  /// Moves a point and continues its legs from their present course.
  void dragPoint(int i, const val& point);
  void insertPoint(int i, const val& point);
  void removePoint(int i) { become(withPointRemoved(curve_.value(), i)); }
  void movePointInOrder(int from, int to) {
    become(withPointMovedInOrder(curve_.value(), from, to));
  }
  void reverse() { become(reversed(curve_.value())); }
  void setKind(const std::string& kind) { become(withKind(curve_.value(), curveKind(kind))); }
  void setClosed(bool closed) { become(withClosed(curve_.value(), closed)); }
  void setWeight(int i, double weight) { become(withWeight(curve_.value(), i, weight)); }
  void setBeta(int i, double beta) { become(withBeta(curve_.value(), i, beta)); }
  void setPoints(const val& points);
  void setWeights(const val& weights);
  void setBetas(const val& betas);
  /// Inserts a control point on the curve and returns its number.
  int insertOnCurve(double parameter);
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
  void become(CurveValue value);
  const CurveLine& line();
  val curvePointToJs(const CurvePoint& at) const;

  MeshHandle& mesh_;
  Legs legs_;
  Curve curve_;
  std::optional<CurveLine> line_;
};

}  // namespace karcher::bindings

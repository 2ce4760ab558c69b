#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bindings/curve_shape.h"
#include "bindings/mesh_handle.h"
#include "bindings/path.h"
#include "curves/query/measure.h"

namespace karcher::bindings {

/// {segment, t, face, bary, position, status}: arrays over all samples, segment by segment.
val samplesToJs(const MeshHandle& mesh, const Array<const Array<CurveSample>*>& segments);

/// The path of a curve's segments, one after another.
struct CurvePath {
  Path path;
  Array<uint8_t> unconverged;  ///< per point, as in JoinedPath
};
void appendSegment(const MeshHandle& mesh, const JoinedPath& segment, CurvePath& path);

/// A list of {segment, t0, t1, reason}.
val bridgedToJs(const Array<const Array<Bridge>*>& segments);

/// A curve as JavaScript holds it. The mesh must outlive it.
class CurveHandle {
 public:
  CurveHandle(MeshHandle& mesh, const CurveOptions& options, const Array<SurfacePoint>& points)
      : mesh_(mesh), curve_(std::make_unique<Curve>(mesh.surface(), options, points)) {}

  /// Keeps the curve as it is, until `join`: an edit and what carries it out may fail.
  void keep() { kept_ = std::make_unique<Curve>(*curve_); }
  /// Makes the curve what it was when it was kept.
  void restore();

  int pointCount() const { return curve_->pointCount(); }
  void movePoint(int i, const val& point);
  /// Moves a point and continues its legs from where they lie.
  void dragPoint(int i, const val& point);
  void insertPoint(int i, const val& point);
  void removePoint(int i) { curve_->removePoint(i); }
  void movePointInOrder(int from, int to) { curve_->movePointInOrder(from, to); }
  void reverse() { curve_->reverse(); }
  void setKind(const std::string& kind) { curve_->setKind(curveKind(kind)); }
  void setClosed(bool closed) { curve_->setClosed(closed); }
  void setWeight(int i, double weight) { curve_->setWeight(i, weight); }
  void setBeta(int i, double beta) { curve_->setBeta(i, beta); }
  void setPoints(const val& points);
  void setWeights(const val& weights);
  void setBetas(const val& betas);
  /// Puts a control point in on the curve; returns its number.
  int insertOnCurve(double parameter);
  /// A list of {points} with shapes (curve_shape.h).
  val splitAt(double parameter);
  val joined(const CurveHandle& other);
  void retrace() { curve_->retrace(); }
  void updateFields() {}
  void findSamples();
  void bridge() {}
  void join();

  val shape() const { return toJs(curve_->shape(), curve_->pointCount()); }
  int segmentCount() const { return curve_->segmentCount(); }
  int levels() const { return curve_->levels(); }
  int fieldsComputed() const { return curve_->fieldsMade(); }
  val points() const;
  val samples() const;
  val bridged() const;
  val path() const;
  /// x, y, z of the path's points, in double or in single precision.
  val polyline(bool inDouble) const;
  val unconverged() const;
  double length() const;

  /// {parameter, point, position, status}
  val pointAt(double parameter);
  /// The same with {inFace, inSpace}, the derivative.
  val tangentAt(double parameter);
  /// `place` is a Float64Array of three numbers. The same as `pointAt` with {distance}.
  val nearest(const val& place);
  double lengthAt(double parameter);
  val pointAtLength(double length);
  /// {parameter, face, bary, position}: arrays over the points.
  val equallySpaced(int count);

 private:
  CurvePath curvePath() const;
  const CurveLine& line();
  val curvePointToJs(const CurvePoint& at) const;

  MeshHandle& mesh_;
  std::unique_ptr<Curve> curve_;
  std::unique_ptr<Curve> kept_;
  std::optional<CurveLine> line_;
};

}  // namespace karcher::bindings

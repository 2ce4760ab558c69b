#pragma once

#include "curves/curve.h"

/// Evaluation of a curve at a parameter.
namespace karcher {

struct CurvePoint {
  double parameter = 0;
  SurfacePoint point;
  /// The status. If it is not kConverged, the point lies on a bridge (bridge.h), or next to a
  /// bridge on the path between the neighbouring samples.
  SampleStatus status = SampleStatus::kConverged;
};

/// The derivative of a curve with respect to its parameter.
struct CurveTangent {
  CurvePoint at;
  Vec2 inFace = Vec2::Zero();   ///< the derivative in the frame of at.point.face
  Vec3 inSpace = Vec3::Zero();  ///< the same vector in space
};

/// A parameter as a segment and t in [0, 1]. At a joint it is the start of the later segment, at
/// the end of an open curve the end of the last segment. On a closed curve it may go around any
/// number of times. Throws Error kBadArgument for a parameter that is not finite or lies outside an
/// open curve.
struct SegmentParameter {
  int segment = 0;
  double t = 0;
};
SegmentParameter segmentParameter(const Curve& curve, double parameter);

CurvePoint pointAt(Curve& curve, const SegmentParameter& at);
inline CurvePoint pointAt(Curve& curve, double parameter) {
  return pointAt(curve, segmentParameter(curve, parameter));
}

/// The tangent by the implicit function theorem: the field sum_i w_i(t) grad d_i^2 stays zero along
/// the curve. Where the curve's point is no center of mass, such as on polylines, or where the
/// theorem does not apply, the tangent is the derivative along the path that joins the samples.
CurveTangent tangentAt(Curve& curve, const SegmentParameter& at);
inline CurveTangent tangentAt(Curve& curve, double parameter) {
  return tangentAt(curve, segmentParameter(curve, parameter));
}

}  // namespace karcher

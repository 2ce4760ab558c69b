#pragma once

#include "curves/curve.h"

/// A curve at one parameter.
namespace karcher {

struct CurvePoint {
  double parameter = 0;
  SurfacePoint point;
  /// Where it is not kConverged, the point lies on a bridge (bridge.h) or, next to one, on the path
  /// that joins the samples around it.
  SampleStatus status = SampleStatus::kConverged;
};

/// The derivative of a curve by its parameter.
struct CurveTangent {
  CurvePoint at;
  Vec2 inFace = Vec2::Zero();   ///< in the frame of at.point.face
  Vec3 inSpace = Vec3::Zero();  ///< the same vector
};

/// A parameter as a segment and t in [0, 1]. At a joint it is the start of a segment, but at the
/// end of an open curve. A closed curve's parameter may go round any number of times. Throws Error
/// kBadArgument for one that is not finite or lies outside an open curve's.
struct SegmentParameter {
  int segment = 0;
  double t = 0;
};
SegmentParameter segmentParameter(const Curve& curve, double parameter);

CurvePoint pointAt(Curve& curve, const SegmentParameter& at);
inline CurvePoint pointAt(Curve& curve, double parameter) {
  return pointAt(curve, segmentParameter(curve, parameter));
}

/// By the implicit function theorem: the field of the curve's point, sum_i w_i(t) grad d_i^2, stays
/// zero along the curve. Where no center of mass is found, and on polylines, the direction of the
/// path.
CurveTangent tangentAt(Curve& curve, const SegmentParameter& at);
inline CurveTangent tangentAt(Curve& curve, double parameter) {
  return tangentAt(curve, segmentParameter(curve, parameter));
}

}  // namespace karcher

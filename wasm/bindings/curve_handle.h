#pragma once

#include <string>

#include "bindings/mesh_handle.h"
#include "curves/curve.h"

namespace karcher::bindings {

/// {segment, t, face, bary, position, status}: arrays over all samples, segment by segment.
val samplesToJs(const MeshHandle& mesh, const Array<const Array<CurveSample>*>& segments);

/// The vertices of a curve's segments, one after another.
struct CurvePolyline {
  Array<double> positions;
  Array<uint8_t> unconverged;  ///< per vertex, as in JoinedPath
  double length = 0;
};
void appendSegment(const MeshHandle& mesh, const JoinedPath& path, CurvePolyline& polyline);

/// A list of {segment, t0, t1, reason}.
val bridgedToJs(const Array<const Array<Bridge>*>& segments);

/// A curve as JavaScript holds it. The mesh must outlive it.
class CurveHandle {
 public:
  CurveHandle(MeshHandle& mesh, const CurveOptions& options, const Array<SurfacePoint>& points)
      : mesh_(mesh), curve_(mesh.surface(), options, points) {}

  int pointCount() const { return curve_.pointCount(); }
  void movePoint(int i, const val& point);
  void insertPoint(int i, const val& point);
  void removePoint(int i) { curve_.removePoint(i); }
  void setKind(const std::string& kind);
  void retrace() { curve_.retrace(); }
  void updateFields() { curve_.updateFields(); }
  void trace() { curve_.trace(); }
  void join() { curve_.join(); }

  val points() const;
  val samples() const;
  val bridged() const;
  val path() const;
  val polylineStatus() const;
  double length() const;

 private:
  CurvePolyline polyline() const;

  MeshHandle& mesh_;
  Curve curve_;
};

CurveKind curveKind(const std::string& name);

}  // namespace karcher::bindings

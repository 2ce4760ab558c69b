#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Geodesics that are to be divided.
namespace karcher {

/// Scratch memory, which can be reused.
struct GeodesicWorkspace {
  StripWorkspace strip;
  SurfacePath back;
};

/// A locally shortest path (local_path.h) between any two points. It is seldom longer than the
/// shortest path of all by more than 1 %, and takes a small part of its time. Writes to `line`,
/// whose memory is reused. Throws Error kUnreachable if the points lie on different components.
void geodesicLine(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                  GeodesicWorkspace& workspace, SurfacePath& line);

/// A line divided in the middle of its length.
struct LineHalves {
  SurfacePath first;
  SurfacePath second;
};
void halve(const TriangleMesh& mesh, const SurfacePath& line, LineHalves& halves);

/// The center of mass of two points with weights 1 - s and s: the point at the part s in [0, 1] of
/// a shortest path from a to b. Throws Error kUnreachable.
SurfacePoint averageOf(const Geometry& geometry, const SurfacePoint& a, const SurfacePoint& b,
                       double s);

}  // namespace karcher

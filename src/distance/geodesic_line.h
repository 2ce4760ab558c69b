#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Geodesics to be cut.
namespace karcher {

/// Scratch memory; reuse one to spare the allocations.
struct GeodesicWorkspace {
  StripWorkspace strip;
  SurfacePath back;
};

/// A locally shortest path (local_path.h), wherever the points lie: in a small part of the time of
/// the shortest path of all, than which it is seldom longer by more than 1 %.
/// Written to `line`, whose memory is used again.
/// Throws Error kUnreachable where the points lie on different components.
void geodesicLine(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                  GeodesicWorkspace& workspace, SurfacePath& line);

/// A line cut in the middle of its length.
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

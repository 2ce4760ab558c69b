#pragma once

#include <functional>
#include <string>

#include "curves/trace/segment.h"
#include "generators/smooth_surface.h"
#include "mesh/triangle_soup.h"
#include "rcm/point_field.h"

/// The deviation of a B-spline on a mesh of a smooth surface from the true one on the surface.
namespace karcher {

/// A family of meshes of one smooth surface, and control points on it.
struct AccuracyFamily {
  std::string name;
  std::function<TriangleSoup(int triangles)> mesh;
  SmoothSurface surface;
  Array<Vec3> points;
};

/// Six tessellations of the plane, three of the sphere and two of the torus. Meshes are the same in
/// every run.
Array<AccuracyFamily> accuracyFamilies();

/// A mesh of a family with about this many triangles, and the true curve: 128 samples a segment.
struct AccuracyCase {
  AccuracyCase(const AccuracyFamily& family, int triangles);

  SmoothSurface smooth;
  Surface surface;
  Array<SurfacePoint> points;
  Array<Vec3> truth;
};

/// Distances on the smooth surface, from the samples' closest points there to the true centers.
struct Accuracy {
  double rms = 0;
  double maximum = 0;
  double turningNoise = 0;  ///< the RMS of the turning angle less the true one, in radians
  int lost = 0;
  double meanEdge = 0;
  double diagonal = 0;
};

/// The accuracy of the engine's curve with some levels. Bridges stand in place of lost samples.
Accuracy measureAccuracy(AccuracyCase& example, const FieldOptions& options, int levels = 0);

/// The accuracy of a curve's samples, segment by segment; only converged ones count.
Accuracy accuracyOfFound(const AccuracyCase& example, const Array<Array<CurveSample>>& segments);

}  // namespace karcher

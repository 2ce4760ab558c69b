#pragma once

#include "intrinsic/surface_path.h"
#include "regions/arrangement.h"

/// Drawings for tests of regions.
namespace karcher {

struct Sheet {
  explicit Sheet(TriangleMesh m);
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  TriangleMesh mesh;
  Geometry geometry;
};

/// A chain of shortest paths from point to point.
SurfacePath chain(const Geometry& geometry, const Array<SurfacePoint>& points, bool closed);

/// A polygon on a mesh in the plane z = 0.
SurfacePath polygonOn(const Geometry& geometry, const Array<Vec2>& corners, bool closed = true);

double surfaceArea(const Geometry& geometry);

class Random;

/// One to four closed polygons that cross themselves and each other, and at times repeat a stretch.
Array<SurfacePath> randomDrawing(const Geometry& geometry, Random& random);

}  // namespace karcher

#pragma once

#include <functional>
#include <string>

#include "generators/smooth_surface.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// A smooth surface, and meshes of it.
struct SmoothShape {
  std::string name;
  SmoothSurface surface;
  std::function<TriangleSoup(int triangles)> mesh;
};

/// A sphere, a torus, a saddle and an ellipsoid, by uneven triangles.
Array<SmoothShape> smoothShapes();

}  // namespace karcher

#pragma once

#include "mesh/types.h"

namespace karcher {

/// Unchecked positions and triangles of a file, a caller or a generator.
struct TriangleSoup {
  Array<Vec3> positions;
  Array<Triangle> triangles;
};

}  // namespace karcher

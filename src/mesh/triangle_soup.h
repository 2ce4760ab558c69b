#pragma once

#include "mesh/types.h"

namespace karcher {

/// Positions and triangles as a file, a caller or a generator gives them: nothing is checked yet.
struct TriangleSoup {
  Array<Vec3> positions;
  Array<Triangle> triangles;
};

}  // namespace karcher

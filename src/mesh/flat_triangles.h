#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Removes triangles whose corners lie on a line, by flips. A flip removes the triangle and cuts
/// each face on the other side of its longest edge in two, by a line to the triangle's third
/// corner. If the longest edge lies on the boundary, the flip only removes the triangle. The
/// surface does not move. Triangles that would take too many flips stay. Returns the number of
/// triangles among the given faces whose corners lie on a line.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

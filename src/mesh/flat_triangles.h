#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Removes triangles whose corners lie on a line, by flips of their longest edge: from the
/// triangle's third corner, a flip cuts the faces on the other side of this edge in two. At a
/// boundary it omits the triangle. The surface does not move. Triangles that would take too many
/// flips stay. Returns the number of such triangles among the given faces.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

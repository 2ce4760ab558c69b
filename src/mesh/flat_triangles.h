#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Removes triangles whose corners lie on a line, by flipping their longest edge: the corner
/// between its ends becomes a corner of the faces on the other side, which are cut in two there. At
/// a boundary the triangle is omitted. The surface does not move. Triangles that would take too
/// many flips stay. Returns the number of triangles removed.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

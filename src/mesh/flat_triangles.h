#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Removes triangles whose corners lie on a line, by flipping their longest edge: the corner
/// between its ends becomes a corner of the faces on the other side, which are cut in two there. At
/// a boundary the triangle is left out. The surface does not move. Returns how many triangles were
/// removed. Triangles that would take too many flips stay.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

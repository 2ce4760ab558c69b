#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Removes triangles whose corners lie on a line. It flips their longest edge: the corner between
/// its ends becomes a corner of the faces on the other side, which are cut in two there. At a
/// boundary it omits the triangle. The surface does not move. Triangles that would take too many
/// flips stay. Returns the number of removed triangles.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

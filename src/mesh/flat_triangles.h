#pragma once

#include "mesh/work_faces.h"

namespace karcher {

/// Takes away triangles whose corners lie on a line, by flipping their longest edge: the corner
/// between its ends becomes a corner of the faces on the other side, which are cut there in two. At
/// a boundary the triangle is left out. The surface stays in its place. Returns how many there
/// were. What would take too many flips stays as it is.
int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces);

}  // namespace karcher

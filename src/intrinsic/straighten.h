#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Straightening of paths in the strip of faces along them, and moves of their ends.
namespace karcher {

/// Pulls a path tight between its ends (strip_path.h). The result is the locally shortest path to
/// which continuous shortening leads. The time grows with the number of faces crossed. The given
/// path may bend, double back or touch vertices; a locally shortest path stays unchanged. The
/// reversed path gives the reversed result, except for ties.
void straighten(const Geometry& geometry, SurfacePath& path, StripWorkspace& workspace);

/// Moves the end of a path to `end`, which lies near the old end, and straightens the path in its
/// homotopy class. Returns false and changes nothing if no strip of faces joins the two ends.
bool moveEnd(const Geometry& geometry, const SurfacePoint& end, SurfacePath& path,
             StripWorkspace& workspace);
bool moveStart(const Geometry& geometry, const SurfacePoint& start, SurfacePath& path,
               StripWorkspace& workspace);

}  // namespace karcher

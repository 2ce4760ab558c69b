#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Straightening of paths in the strip of faces along them, and moves of their ends.
namespace karcher {

/// Replaces a path by the locally shortest one that continuous shortening leads to, by pulling it
/// tight between its ends (strip_path.h). The time grows with the number of faces crossed. A path
/// may bend, double back or touch vertices; a locally shortest one stays unchanged. The result of
/// the reversed path is the reversed result, except for ties.
void straighten(const Geometry& geometry, SurfacePath& path, StripWorkspace& workspace);

/// Moves the end of a path to `end`, which lies near the old end, and straightens the path in its
/// homotopy class. Returns false and changes nothing if no strip of faces joins the two ends.
bool moveEnd(const Geometry& geometry, const SurfacePoint& end, SurfacePath& path,
             StripWorkspace& workspace);
bool moveStart(const Geometry& geometry, const SurfacePoint& start, SurfacePath& path,
               StripWorkspace& workspace);

}  // namespace karcher

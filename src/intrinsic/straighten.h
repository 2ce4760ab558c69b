#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Paths that are pulled tight in the strip of faces along them, and moved by their ends.
namespace karcher {

/// Replaces a path by the locally shortest one that it can be shortened to continuously: it is
/// pulled tight between its ends (strip_path.h). Costs by the faces that it crosses. What bends,
/// doubles back or touches vertices is shortened; a path that is locally shortest stays.
/// With the path reversed the result is the reversed result, but for ties.
void straighten(const Geometry& geometry, SurfacePath& path, StripWorkspace& workspace);

/// Moves the end of a path to `end`, which lies near the old one, and straightens: the path that
/// the moving end draws out, in the old one's class. Returns false, and changes nothing, where no
/// strip of faces joins the ends.
bool moveEnd(const Geometry& geometry, const SurfacePoint& end, SurfacePath& path,
             StripWorkspace& workspace);
bool moveStart(const Geometry& geometry, const SurfacePoint& start, SurfacePath& path,
               StripWorkspace& workspace);

}  // namespace karcher

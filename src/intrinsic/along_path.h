#pragma once

#include "intrinsic/geometry.h"

/// Points along paths on the surface, of which consecutive points share a face.
namespace karcher {

/// The point at the part s of the straight line from a to b, in a face that holds both.
SurfacePoint pointBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b,
                          double s);

/// The number of the path's piece (between points k and k + 1) at a length from its start, which is
/// clamped to the path.
int pieceAt(const Array<double>& lengths, double length);

/// The point of a path at a length from its start.
SurfacePoint pointAlong(const TriangleMesh& mesh, const Array<SurfacePoint>& path,
                        const Array<double>& lengths, double length);

}  // namespace karcher

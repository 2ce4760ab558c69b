#pragma once

#include "generators/random.h"
#include "intrinsic/geometry.h"

/// Random points of meshes.
namespace karcher {

/// A uniform random point in a random face.
SurfacePoint randomPoint(const TriangleMesh& mesh, Random& random);

/// A random point in a face, on an edge or at a vertex.
SurfacePoint randomPlace(const TriangleMesh& mesh, Random& random);

struct PointPair {
  SurfacePoint from;
  SurfacePoint to;
};

/// Pairs of points `least` to `most` of the diagonal apart by exact distances (from the vertex of
/// the second one's face). `choose`, one of the above, chooses each point.
Array<PointPair> randomPairs(const Geometry& geometry, Random& random, int count,
                             SurfacePoint (*choose)(const TriangleMesh&, Random&),
                             double least = 0.05, double most = 0.2);

}  // namespace karcher

#pragma once

#include <complex>

#include "intrinsic/geometry.h"

/// A triangulation of a surface, given by its edge lengths alone: the mesh itself, or the intrinsic
/// Delaunay triangulation, which has the same vertices and metric but other edges. Flips replace
/// edges and compute the directions in which the new edges leave their vertices, after N. Sharp, Y.
/// Soliman, K. Crane, "The Vector Heat Method" (2019), section 5.4.
namespace karcher {

/// A tangent vector as a complex number.
using Complex = std::complex<double>;

/// The half-edges of a triangulation, numbered as in TriangleMesh: 3 f + k in face f. Two edges may
/// join the same pair of vertices, and an edge may join a vertex to itself.
struct IntrinsicTriangulation {
  const Geometry* geometry = nullptr;
  Array<int> tail;       ///< the tail of each half-edge
  Array<int> twin;       ///< the twin of each half-edge, -1 at the boundary
  Array<double> length;  ///< the length of each half-edge
  /// the unscaled direction of each half-edge in the frame of its tail in `geometry`
  Array<double> direction;

  int vertexCount() const { return geometry->mesh->vertexCount(); }
  int faceCount() const { return tail.count() / 3; }
  int head(int h) const { return tail[next(h)]; }
};

/// The mesh's own triangles. The geometry must outlive the result.
IntrinsicTriangulation meshTriangulation(const Geometry& geometry);

/// Flips edges until the two angles opposite to each edge sum to at most pi. Stops early if the
/// flips reach 100 times the number of half-edges. Returns the number of flips.
int makeDelaunay(IntrinsicTriangulation& triangulation);

/// Twice the area of face f.
double doubleArea(const IntrinsicTriangulation& triangulation, int f);

/// The angle, in radians, at the tail of half-edge h in its face.
double cornerAngle(const IntrinsicTriangulation& triangulation, int h);

/// The cotangent of the angle opposite to half-edge h in its face.
double oppositeCotangent(const IntrinsicTriangulation& triangulation, int h);

/// Half-edge h as a vector in the rescaled frame of its tail.
Complex vectorAtTail(const IntrinsicTriangulation& triangulation, int h);

/// The reversed half-edge h, from head to tail, in the rescaled frame of its head.
Complex vectorAtHead(const IntrinsicTriangulation& triangulation, int h);

}  // namespace karcher

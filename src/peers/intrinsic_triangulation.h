#pragma once

#include <complex>

#include "intrinsic/geometry.h"

/// A triangulation of a surface given by its edge lengths alone: the mesh itself, or the intrinsic
/// Delaunay triangulation, which has the same vertices and metric but other edges.
///
/// Edges are flipped, and the directions in which they leave their vertices are kept, after N.
/// Sharp, Y. Soliman, K. Crane, "The Vector Heat Method" (2019), section 5.4.
namespace karcher {

/// A tangent vector as a complex number.
using Complex = std::complex<double>;

/// Half-edges are numbered as in TriangleMesh: 3 f + k in face f. Two edges may join the same pair
/// of vertices, and an edge a vertex with itself.
struct IntrinsicTriangulation {
  const Geometry* geometry = nullptr;
  Array<int> tail;          ///< per half-edge
  Array<int> twin;          ///< per half-edge, -1 at the boundary
  Array<double> length;     ///< per half-edge
  Array<double> direction;  ///< per half-edge, unscaled, in the frame of its tail in `geometry`

  int vertexCount() const { return geometry->mesh->vertexCount(); }
  int faceCount() const { return tail.count() / 3; }
  int head(int h) const { return tail[next(h)]; }
};

/// The mesh's own triangles. The geometry must outlive the result.
IntrinsicTriangulation meshTriangulation(const Geometry& geometry);

/// Flips edges until the angles opposite to each sum to at most pi, or until 100 flips for each
/// edge. Returns the number of flips.
int makeDelaunay(IntrinsicTriangulation& triangulation);

/// Twice the area of face f.
double doubleArea(const IntrinsicTriangulation& triangulation, int f);

/// The angle at the tail of half-edge h in its face, radians.
double cornerAngle(const IntrinsicTriangulation& triangulation, int h);

/// The cotangent of the angle opposite to half-edge h in its face.
double oppositeCotangent(const IntrinsicTriangulation& triangulation, int h);

/// Half-edge h as a vector in the rescaled frame of its tail.
Complex vectorAtTail(const IntrinsicTriangulation& triangulation, int h);

/// The reversed half-edge h, from head to tail, in the rescaled frame of its head.
Complex vectorAtHead(const IntrinsicTriangulation& triangulation, int h);

}  // namespace karcher

#pragma once

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

/// Lengths, angles, tangent frames and the discrete connection of a mesh.
///
/// Frame of a face: corner 0 at the origin, corner 1 on the positive x axis, corner 2 above it.
/// Frame of a vertex: directions count counterclockwise from its `outgoing` half-edge, by the
/// cumulated corner angle times `angleScale` = 2 pi / total angle. At the boundary the scale is 1,
/// since any other scale would distort directions on a plane. The direction of a traced path is
/// unscaled: the cumulated corner angle itself.
///
/// Connection: F. Knoppel, K. Crane, U. Pinkall, P. Schroder, "Globally Optimal Direction Fields"
/// (2013), section 3, evaluated at the centroids of faces.
namespace karcher {

struct Geometry {
  const TriangleMesh* mesh = nullptr;
  Array<double> edgeLength;   ///< the length of each half-edge
  Array<double> cornerAngle;  ///< the angle at the tail of each half-edge, in radians
  /// the unscaled direction of each half-edge in the frame of its tail
  Array<double> cumulatedAngle;
  Array<double> totalAngle;  ///< the sum of the corner angles of each vertex
  Array<double> angleScale;  ///< 2 pi / totalAngle for each vertex, or 1 at the boundary
  Array<Vec2> apex;          ///< corner 2 of each face, in its frame
  /// for each half-edge, a unit vector that turns vectors in the frame of its tail into the frame
  /// of its face
  Array<Vec2> vertexToFace;
  double meanEdge = 0;
  double shortestEdge = 0;
  double longestEdge = 0;
  double diagonal = 0;  ///< the diagonal of the bounding box
  /// Twice the largest distance of a vertex from the mean of all vertices. Unlike the diagonal, it
  /// is invariant under rotations, so that searches use it as the size of the mesh.
  double extent = 0;
};

/// The mesh must outlive the result.
Geometry buildGeometry(const TriangleMesh& mesh);

/// Corner k of face f in the face's frame.
inline Vec2 cornerInFace(const Geometry& geometry, int f, int k) {
  if (k == 0) return Vec2::Zero();
  if (k == 1) return {geometry.edgeLength[3 * f], 0};
  return geometry.apex[f];
}

/// A surface point in the frame of its face.
inline Vec2 pointInFace(const Geometry& geometry, const SurfacePoint& p) {
  return {p.bary[1] * geometry.edgeLength[3 * p.face] + p.bary[2] * geometry.apex[p.face].x(),
          p.bary[2] * geometry.apex[p.face].y()};
}

/// The vector from one point of face f to another, in the frame of the face. It is computed from
/// differences of weights, so that a step between points of one edge is parallel to the edge,
/// however large the face.
Vec2 stepInFace(const Geometry& geometry, int f, const SurfacePoint& from, const SurfacePoint& to);

/// Half-edge h as a vector in the frame of its face.
inline Vec2 halfedgeInFace(const Geometry& geometry, int h) {
  return cornerInFace(geometry, faceOf(h), cornerOf(next(h))) -
         cornerInFace(geometry, faceOf(h), cornerOf(h));
}

/// The vertex opposite to half-edge h, in the frame of h: the tail of h is the origin, and its head
/// lies on the positive x axis. So y is the face's height over h.
inline Vec2 oppositeOverHalfedge(const Geometry& geometry, int h) {
  const int f = faceOf(h);
  if (cornerOf(h) == 0) return geometry.apex[f];
  const Vec2 edge = halfedgeInFace(geometry, h) / geometry.edgeLength[h];
  return rotateBack(edge, -halfedgeInFace(geometry, previous(h)));
}

/// Twice the area of face f.
inline double doubleArea(const Geometry& geometry, int f) {
  return geometry.edgeLength[3 * f] * geometry.apex[f].y();
}

/// Barycentric weights (sum 1, any sign) of a position in the frame of face f.
Vec3 barycentric(const Geometry& geometry, int f, const Vec2& x);

/// Turns a vector in the frame of face f into the frame of the face across half-edge h of f,
/// unfolded about the edge. The half-edge must have a twin.
Vec2 acrossEdge(const Geometry& geometry, int h, const Vec2& vector);

/// Converts a vector in the frame of face f to space.
Vec3 toSpace(const Geometry& geometry, int f, const Vec2& vector);
/// Projects a vector in space to the frame of face f.
Vec2 toFace(const Geometry& geometry, int f, const Vec3& vector);

/// The unscaled direction of a vector at the tail of half-edge h: the cumulated angle of h plus the
/// angle from h to the vector. The vector is in the frame of h's face and points into the corner.
double directionAtTail(const Geometry& geometry, int h, const Vec2& vector);

/// The direction of half-edge h as a unit vector in the frames of its ends. At the head it points
/// away from the edge.
struct EdgeDirection {
  Vec2 tail;
  Vec2 head;
};
EdgeDirection directionOfEdge(const Geometry& geometry, int h);

/// The corner (a half-edge that leaves the vertex) into which an unscaled direction points, and the
/// angle from that half-edge to the direction. Directions wrap around at interior vertices. At the
/// boundary, a direction outside [0, totalAngle] is turned by 2 pi in either sense if it then lies
/// inside. Otherwise it leaves the surface, and `halfedge` is -1.
struct CornerDirection {
  int halfedge = -1;
  double angle = 0;
};
CornerDirection cornerOfDirection(const Geometry& geometry, int vertex, double direction);

}  // namespace karcher

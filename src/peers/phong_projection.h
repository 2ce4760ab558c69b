#pragma once

#include <optional>

#include "intrinsic/geometry.h"
#include "peers/intrinsic_triangulation.h"

/// Phong projection: D. Panozzo, I. Baran, O. Diamanti, O. Sorkine-Hornung, "Weighted Averages on
/// Surfaces", ACM Transactions on Graphics 32 (2013), section 4. A mesh embedded in eight
/// dimensions has a tangent plane at each vertex. Between the vertices the planes change
/// continuously over the surface. A point of the space projects to the point of the mesh whose
/// plane is orthogonal to the line between the two points. Unlike the nearest point, this
/// projection depends smoothly on the point.
namespace karcher {

inline constexpr int kEmbeddingDimensions = 8;
using EmbeddedPoint = Eigen::Matrix<double, kEmbeddingDimensions, 1>;
/// A plane as two orthonormal rows.
using TangentPlane = Eigen::Matrix<double, 2, kEmbeddingDimensions>;

/// The tangent plane at each vertex, with the orientation of the mesh. It is a least-squares fit of
/// the vertex's embedded edges to the lengths and directions of the edges in the vertex's frame.
Array<TangentPlane> tangentPlanes(const Geometry& geometry, const Array<EmbeddedPoint>& positions);

/// Whether face f is turned over, or has no area, in the tangent plane of one of its corners, so
/// that projections are not unique.
bool isFolded(const TriangleMesh& mesh, const Array<EmbeddedPoint>& positions,
              const Array<TangentPlane>& planes, int f);

class PhongSurface {
 public:
  /// The mesh must outlive the surface.
  PhongSurface(const TriangleMesh& mesh, Array<EmbeddedPoint> positions,
               Array<TangentPlane> planes);

  EmbeddedPoint position(const SurfacePoint& point) const;

  /// The blended tangent plane at a point: orthonormal rows.
  TangentPlane planeAt(const SurfacePoint& point) const;

  /// The projection of p. The search tries the start's face, then walks from face to face from the
  /// vertex nearest to p, then tries all faces around this vertex. The result is empty if the
  /// projection lies beyond the boundary or in none of these faces.
  std::optional<SurfacePoint> project(const EmbeddedPoint& p, const SurfacePoint& start) const;

 private:
  /// A face in the coordinates of Newton's method. Positions are relative to corner 0, and are
  /// projected to the plane at each corner. The two coordinates in a plane form a complex number.
  struct Patch {
    /// the turn from corner k's plane to the frame of the blend along the edge from k to k + 1
    Complex turnFirst[3];
    Complex turnSecond[3];  ///< the same for the edge from k - 1 to k
    Complex corners[3][3];  ///< corner c in the plane of corner k, as [k][c]
    Complex target[3];      ///< the point to project
  };
  struct FaceProjection {
    Vec3 bary;
    /// whether the projection is in the face; if not, it may be beyond the side opposite to the
    /// corner with the smallest weight in `bary`
    bool found = false;
  };

  Patch patchOf(int f) const;
  FaceProjection projectInFace(int f, const EmbeddedPoint& p) const;
  std::optional<SurfacePoint> walk(const EmbeddedPoint& p, int face) const;
  std::optional<SurfacePoint> searchAround(const EmbeddedPoint& p, int vertex) const;
  int nearestVertex(const EmbeddedPoint& p, int vertex) const;

  const TriangleMesh& mesh_;
  Array<EmbeddedPoint> positions_;
  Array<TangentPlane> planes_;
};

}  // namespace karcher

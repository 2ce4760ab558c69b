#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/strip_search.h"

/// Locally shortest paths in a strip of faces. The strip unfolds into the plane, and the funnel
/// algorithm pulls the path tight between its sides (D. Lee, F. Preparata, "Euclidean shortest
/// paths in the presence of rectilinear barriers", 1984). The path may then bend at a vertex with
/// less than pi of surface on the side away from the strip. If so, the strip turns to that side,
/// and the path is pulled tight again (S. Xin, G. Wang, "Efficiently determining a locally exact
/// shortest path on polyhedral surfaces", 2007; N. Sharp, K. Crane, "You Can Find Geodesic Paths in
/// Triangle Meshes by Just Flipping Edges", 2020). Each turn shortens the path, until no bend
/// allows another turn. A turn changes only the adjacent legs.
namespace karcher {

/// A strip to pull tight, and reusable scratch memory.
struct StripWorkspace {
  /// The given strip; after a call, the strip that contains the path.
  Strip strip;

  /// An unfolded crossing: the ends of its half-edge, between which the strip passes.
  struct Portal {
    Vec2 right;  ///< the tail of the half-edge
    Vec2 left;   ///< the head of the half-edge
  };
  /// A vertex where the path touches the strip's side.
  struct Bend {
    int portal = 0;  ///< the index of a crossed edge that ends at the vertex
    bool onLeft = false;
    double leg = 0;  ///< the length of the path from the previous bend
    /// The angle, in radians, from the leg before the bend to the first crossed edge at the vertex.
    double before = 0;
    /// The angle, in radians, from the last crossed edge at the vertex to the leg after the bend.
    double after = 0;
    /// The angle of the surface at the vertex, on the side away from the strip.
    double outside = 0;
  };
  /// A vertex beside the path, and the length that the path may save if it passes the vertex on
  /// the other side.
  struct Passage {
    int portal = 0;
    bool onLeft = false;
    double gain = 0;
  };
  Array<Portal> portals;
  Array<Bend> bends;
  Array<Bend> newBends;
  Array<int> turned;
  Array<Passage> passages;
  Strip keptStrip;
  Array<Bend> keptBends;

  StripSearchWorkspace search;
  Strip motion;  ///< the motion of a path's end (straighten.h)
};

/// Appends to `out` the path from `from`, in the strip's first face, to `to`, in its last face. The
/// appended points are the path's crossings of edges, the vertices at which it bends, and `to`, but
/// not `from`. Consecutive points share a face. Returns the length of the appended path.
double appendStripPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                       StripWorkspace& workspace, Array<SurfacePoint>& out);

/// The same path, but the strip also passes over vertices beside the path as long as this shortens
/// the path.
double appendShorterStripPath(const Geometry& geometry, const SurfacePoint& from,
                              const SurfacePoint& to, StripWorkspace& workspace,
                              Array<SurfacePoint>& out);

/// Whether `point` lies in face f, on its edges or at its corners.
bool liesInFace(const TriangleMesh& mesh, const PointLocation& point, int f);

/// A face that holds both points, or -1.
int commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

inline bool haveCommonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return commonFace(mesh, a, b) >= 0;
}

/// The indices of the points of a path without those at the place of the point before. Such a point
/// stays if it alone joins its neighbors, which lie in different faces.
Array<int> pointsWithoutRepetitions(const TriangleMesh& mesh, const Array<SurfacePoint>& points);

}  // namespace karcher

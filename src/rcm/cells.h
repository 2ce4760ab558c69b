#pragma once

#include "mesh/surface_point.h"

/// The triangles in which a blended field is linear. They are the faces of the mesh or, if faces
/// are cut, four triangles in each face: the lines between the midpoints of the edges cut the face.
///
/// A cut face f has the cells 4 f + k at its corners k and the cell 4 f + 3 in its middle:
///
///             2
///            / \            Corners of cell k: corner k of the face, the midpoint of the half-edge
///           / 2 \           that leaves it, the midpoint of the half-edge that enters it.
///         m2 --- m1         Corners of cell 3: m0, m1, m2, where mk is the midpoint of half-edge
///         / \ 3 / \         3 f + k.
///        / 0 \ / 1 \        .
///       0 --- m0 --- 1
///
/// Half-edge 3 c + k runs along cell c from its corner k, as in a mesh.
namespace karcher {

/// A point in a cell.
struct CellPoint {
  int cell = 0;
  Vec3 bary = Vec3::Zero();
};

class Cells {
 public:
  /// The mesh must outlive the object.
  Cells(const TriangleMesh& mesh, bool cut) : mesh_(mesh), cut_(cut) {}

  bool cut() const { return cut_; }
  void setCut(bool cut) { cut_ = cut; }

  CellPoint at(const SurfacePoint& point) const {
    return cut_ ? cutAt(point) : CellPoint{point.face, point.bary};
  }

  /// The point of the surface with these weights in a cell, cleaned by `clampedPoint`.
  SurfacePoint point(int cell, const Vec3& bary) const {
    return cut_ ? clampedPoint(cell / 4, toFaceWeights(cell, bary)) : clampedPoint(cell, bary);
  }

  /// Converts barycentric weights of a cell, or differences of such weights, to weights of its
  /// face.
  Vec3 inFace(int cell, const Vec3& bary) const { return cut_ ? toFaceWeights(cell, bary) : bary; }

  /// The point at parameter s in [0, 1] along half-edge h.
  SurfacePoint pointOnEdge(int h, double s) const;

  /// The tail of half-edge h. The result is in the same face for all half-edges that leave this
  /// point.
  SurfacePoint tailOf(int h) const;

  /// The half-edge in the opposite direction, in the cell across h; -1 at the boundary.
  int twin(int h) const { return cut_ ? cutTwin(h) : mesh_.twin[h]; }

  /// The first of the half-edges that leave h's tail (TriangleMesh::outgoing).
  int firstAround(int h) const;
  /// The half-edges that leave h's tail, counterclockwise from `firstAround`.
  HalfedgesAround<Cells> around(int h) const { return {*this, firstAround(h)}; }

 private:
  static CellPoint cutAt(const SurfacePoint& point);
  static Vec3 toFaceWeights(int cell, const Vec3& bary);
  int cutTwin(int h) const;

  const TriangleMesh& mesh_;
  bool cut_;
};

/// The half-edge that leaves h's tail next after h, counterclockwise; -1 past the boundary.
inline int rotateLeft(const Cells& cells, int h) { return cells.twin(previous(h)); }

}  // namespace karcher

#pragma once

#include <array>

#include "mesh/surface_point.h"

/// Conversion of the caller's (input) numbers to the engine's and back. Points keep their
/// positions.
namespace karcher {

/// A face of the engine that is a part of an input triangle.
struct FacePiece {
  int face = 0;
  /// The corners of the engine's face, each as barycentric weights in the input triangle.
  std::array<Vec3, 3> corners;
};

/// An input triangle that did not become a single face of the engine.
struct FaceImage {
  Triangle corners;            ///< the input vertices, the first of several welded ones
  std::array<Vec3, 3> places;  ///< the places of the corners
  Array<FacePiece> pieces;     ///< the pieces; empty for an omitted triangle
  bool isDuplicate = false;    ///< whether the triangle repeats another one
  Array<int> beside;           ///< the engine's faces at its corners, for a triangle without pieces
};

struct Numbering {
  /// The engine's vertex for each input vertex; -1 for a dropped vertex. Welded vertices share an
  /// engine vertex. For a split vertex, the entry is its first part.
  Array<int> engineVertex;
  Array<int> inputVertex;  ///< the first input vertex that became each engine vertex
  /// For each input triangle, the face of the engine with the same corners, in the same order
  /// unless the face was turned over. If there is no such face, the entry is -1 - i, and images[i]
  /// describes the triangle's image.
  Array<int> engineFace;
  Array<int> inputFace;  ///< the input triangle that contains each engine face
  /// 1 for each input triangle whose face was turned over, so that corners 1 and 2 are swapped;
  /// empty if no face was turned over
  Array<uint8_t> turnedOver;
  Array<FaceImage> images;

  int inputFaceCount() const { return engineFace.count(); }
  /// Whether the face or the pieces of an input triangle were turned over.
  bool isTurnedOver(int t) const;
  /// The input vertices at the corners of an input triangle. The first of several welded vertices
  /// stands for all of them.
  Triangle inputCorners(const TriangleMesh& mesh, int inputFace) const;
  /// The engine's vertices at the corners of an input triangle; -1 at each corner of a duplicate,
  /// and for dropped vertices.
  Triangle engineCorners(const TriangleMesh& mesh, int inputFace) const;
};

/// Converts a caller's point to the engine's and checks it by `checkedPoint`. If the input triangle
/// was cut, the result lies in the piece that contains the point. If the triangle was omitted, the
/// result is the nearest point that a search from the adjacent faces finds. If the triangle has no
/// adjacent faces, the result is the nearest point of the mesh, which must be at most 1e-6
/// diagonals away. Throws what `checkedPoint` throws, and Error kBadIndex if there is no such
/// point.
SurfacePoint toEngine(const Numbering& numbering, const TriangleMesh& mesh, int inputFace,
                      const Vec3& bary);

/// The same point in the caller's numbers: `face` is the input triangle.
SurfacePoint toInput(const Numbering& numbering, const SurfacePoint& point);

/// Converts a change of a point's weights in its engine face to a change of its weights in the
/// input triangle.
Vec3 changeToInput(const Numbering& numbering, int engineFace, const Vec3& change);

}  // namespace karcher

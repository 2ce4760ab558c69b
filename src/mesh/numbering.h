#pragma once

#include <array>

#include "mesh/surface_point.h"

/// Turns the caller's (input) numbers into the engine's and back. A point keeps its place.
namespace karcher {

/// A part of an input triangle that became a face of the engine.
struct FacePiece {
  int face = 0;
  /// For each corner of the engine's face, its weights in the input triangle.
  std::array<Vec3, 3> corners;
};

/// An input triangle that is not one face of the engine.
struct FaceImage {
  Triangle corners;            ///< the input vertices
  std::array<Vec3, 3> places;  ///< of the corners
  Array<FacePiece> pieces;     ///< none where it was left out
  Array<int> beside;           ///< then: faces of the engine at its corners
};

struct Numbering {
  /// Per input vertex the engine's; -1 if it was dropped. Vertices that were welded share one. Of a
  /// vertex that was split it is the first part.
  Array<int> engineVertex;
  Array<int> inputVertex;  ///< per engine vertex, the first input vertex that became it
  /// Per input triangle the engine's face that is all of it, with the same order of corners; or
  /// -1 - i, where images[i] says what became of it.
  Array<int> engineFace;
  Array<int> inputFace;  ///< per engine face the input triangle that it is, or is a part of
  /// Per input triangle 1 if its face was turned over, so that corners 1 and 2 changed places;
  /// empty if none was.
  Array<uint8_t> turnedOver;
  Array<FaceImage> images;

  int inputFaceCount() const { return engineFace.count(); }
  bool isTurnedOver(int t) const { return !turnedOver.empty() && turnedOver[t] != 0; }
  /// The input vertices of an input triangle; of those that are welded, the first.
  Triangle inputCorners(const TriangleMesh& mesh, int inputFace) const;
};

/// A caller's point as the engine's, checked by `checkedPoint`. If the input triangle was cut, it
/// is in the piece that holds the point; if it was left out, it is the nearest point of the faces
/// beside. Throws what `checkedPoint` throws, and Error kBadIndex for a triangle that was left out
/// and lies apart from all others.
SurfacePoint toEngine(const Numbering& numbering, const TriangleMesh& mesh, int inputFace,
                      const Vec3& bary);

/// The same point in the caller's numbers: `face` is the input triangle.
SurfacePoint toInput(const Numbering& numbering, const SurfacePoint& point);

/// A change of a point's weights in its engine face, as that of the weights in the input triangle.
Vec3 changeToInput(const Numbering& numbering, int engineFace, const Vec3& change);

}  // namespace karcher

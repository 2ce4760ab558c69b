#pragma once

#include <array>

#include "mesh/surface_point.h"

/// Conversion of the caller's (input) numbers to the engine's and back. Points keep their
/// positions.
namespace karcher {

/// A part of an input triangle that became a face of the engine.
struct FacePiece {
  int face = 0;
  /// The weights of each corner of the engine's face in the input triangle.
  std::array<Vec3, 3> corners;
};

/// An input triangle that is not one face of the engine.
struct FaceImage {
  Triangle corners;            ///< the input vertices
  std::array<Vec3, 3> places;  ///< of the corners
  Array<FacePiece> pieces;     ///< none where it was left out
  Array<int> beside;           ///< if there are no pieces: the engine's faces at its corners
};

struct Numbering {
  /// The engine's vertex for each input vertex; -1 if it was dropped. Welded vertices share one.
  /// For a vertex that was split it is the first part.
  Array<int> engineVertex;
  Array<int> inputVertex;  ///< per engine vertex, the first input vertex that became it
  /// For each input triangle, the engine's face that equals it, with the same order of corners, or
  /// else -1 - i, where images[i] describes what became of it.
  Array<int> engineFace;
  Array<int> inputFace;  ///< per engine face the input triangle that it is, or is a part of
  /// 1 for each input triangle whose face was turned over, which swaps corners 1 and 2; empty if
  /// none was.
  Array<uint8_t> turnedOver;
  Array<FaceImage> images;

  int inputFaceCount() const { return engineFace.count(); }
  bool isTurnedOver(int t) const { return !turnedOver.empty() && turnedOver[t] != 0; }
  /// The input vertices of an input triangle, each replaced by the first of those it is welded to.
  Triangle inputCorners(const TriangleMesh& mesh, int inputFace) const;
};

/// Converts a caller's point to the engine's and checks it by `checkedPoint`. If the input triangle
/// was cut, the result is in the piece that holds the point; if it was left out, the result is the
/// nearest point of the adjacent faces. Throws what `checkedPoint` throws, and Error kBadIndex for
/// a triangle that was left out and has no adjacent faces.
SurfacePoint toEngine(const Numbering& numbering, const TriangleMesh& mesh, int inputFace,
                      const Vec3& bary);

/// The same point in the caller's numbers: `face` is the input triangle.
SurfacePoint toInput(const Numbering& numbering, const SurfacePoint& point);

/// Converts a change of a point's weights in its engine face to one of its weights in the input
/// triangle.
Vec3 changeToInput(const Numbering& numbering, int engineFace, const Vec3& change);

}  // namespace karcher

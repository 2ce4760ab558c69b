#pragma once

#include <array>

#include "mesh/surface_point.h"

/// From the caller's (input) numbers to the engine's and back: points keep their place.
namespace karcher {

/// A part of an input triangle that became a face of the engine.
struct FacePiece {
  int face = 0;
  /// Per corner of the engine's face its weights in the input triangle.
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
  /// Per input vertex; welded ones share a number, dropped ones have -1, of one that was split it
  /// is the first.
  Array<int> engineVertex;
  Array<int> inputVertex;  ///< per engine vertex, the first input vertex that became it
  /// Per input triangle the face that it is as a whole, its corners in their order; or -1 - i where
  /// images[i] tells what became of it.
  Array<int> engineFace;
  Array<int> inputFace;  ///< per engine face the input triangle that it is, or is a part of
  /// Per input triangle 1 where its face was turned over, so that the corners 1 and 2 have changed
  /// places; empty where none was.
  Array<uint8_t> turnedOver;
  Array<FaceImage> images;

  int inputFaceCount() const { return engineFace.count(); }
  bool isTurnedOver(int t) const { return !turnedOver.empty() && turnedOver[t] != 0; }
  /// The input vertices of an input triangle; of those that are welded, the first.
  Triangle inputCorners(const TriangleMesh& mesh, int inputFace) const;
};

/// A caller's point, checked as by `checkedPoint`. Where the input triangle was cut it is the point
/// of the part that holds it; where it was left out, the nearest point beside.
/// Throws as `checkedPoint`, and Error kBadIndex for a triangle that was left out and lies apart
/// from all others.
SurfacePoint toEngine(const Numbering& numbering, const TriangleMesh& mesh, int inputFace,
                      const Vec3& bary);

/// The same point in the caller's numbers: `face` is the input triangle.
SurfacePoint toInput(const Numbering& numbering, const SurfacePoint& point);

/// A change of a point's weights in its engine face, as that of the weights in the input triangle.
Vec3 changeToInput(const Numbering& numbering, int engineFace, const Vec3& change);

}  // namespace karcher

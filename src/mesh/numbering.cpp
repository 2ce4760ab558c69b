#include "mesh/numbering.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "mesh/nearest_in_triangle.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Coordinates in a plane. Weights sum to 1, so that two of them suffice.
Vec2 plane(const Vec3& bary) { return {bary[1], bary[2]}; }

/// The area of a piece relative to its triangle, negative if the piece was turned over.
double areaOf(const FacePiece& piece) {
  const Vec2 a = plane(piece.corners[0]);
  return cross(plane(piece.corners[1]) - a, plane(piece.corners[2]) - a);
}

/// Converts a point's barycentric weights in the whole triangle to its weights in a piece.
Vec3 weightsInPiece(const FacePiece& piece, const Vec3& bary) {
  const Vec2 a = plane(piece.corners[0]);
  const Vec2 u = plane(piece.corners[1]) - a;
  const Vec2 v = plane(piece.corners[2]) - a;
  const Vec2 p = plane(bary) - a;
  const double area = areaOf(piece);
  const double second = cross(p, v) / area;
  const double third = cross(u, p) / area;
  return {1 - second - third, second, third};
}

SurfacePoint inPieces(const FaceImage& image, const Vec3& bary) {
  SurfacePoint best;
  double most = -kInfinity;
  for (const FacePiece& piece : image.pieces) {
    const Vec3 weights = weightsInPiece(piece, bary);
    const double least = weights.minCoeff();
    if (!(least > most)) continue;
    most = least;
    best = {piece.face, weights};
  }
  // The point can be outside all pieces only by rounding. This rounding is large if the piece is
  // much smaller than the whole triangle.
  best.bary = best.bary.cwiseMax(0);
  best.bary /= best.bary.sum();
  return clampedPoint(best.face, best.bary);
}

Vec3 placeIn(const FaceImage& image, const Vec3& bary) {
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (bary[k] != 0) place += bary[k] * image.places[static_cast<size_t>(k)];
  }
  return place;
}

/// The nearest point that a search finds. The search begins at the adjacent faces. As long as it
/// comes nearer, it goes on to the faces around the nearest face. So it gets past other omitted
/// triangles, several of which may lie side by side.
SurfacePoint nearestBeside(const TriangleMesh& mesh, const FaceImage& image, const Vec3& place) {
  SurfacePoint best;
  double nearest = kInfinity;
  const auto consider = [&](int f) {
    const Triangle& t = mesh.faces[f];
    const SurfacePoint point = clampedPoint(
        f,
        nearestInTriangle(place, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
    const double distance = (position(mesh, point) - place).squaredNorm();
    if (!(distance < nearest)) return false;
    nearest = distance;
    best = point;
    return true;
  };
  for (const int f : image.beside) consider(f);
  bool nearer = nearest > 0;
  // Each step leads to a nearer face, so that no face occurs twice.
  for (int step = 0; nearer && step < mesh.faceCount(); ++step) {
    nearer = false;
    const Triangle corners = mesh.faces[best.face];
    for (const int v : corners) {
      for (const int h : outgoingHalfedges(mesh, v)) nearer = consider(faceOf(h)) || nearer;
    }
  }
  return best;
}

const FacePiece& pieceOf(const Numbering& numbering, int engineFace) {
  const int image = -1 - numbering.engineFace[numbering.inputFace[engineFace]];
  const Array<FacePiece>& pieces = numbering.images[image].pieces;
  return *std::find_if(pieces.begin(), pieces.end(),
                       [&](const FacePiece& piece) { return piece.face == engineFace; });
}

}  // namespace

bool Numbering::isTurnedOver(int t) const {
  const int f = engineFace[t];
  if (f >= 0) return !turnedOver.empty() && turnedOver[t] != 0;
  const Array<FacePiece>& pieces = images[-1 - f].pieces;
  return !pieces.empty() && areaOf(pieces[0]) < 0;
}

Triangle Numbering::inputCorners(const TriangleMesh& mesh, int t) const {
  const int f = engineFace[t];
  if (f < 0) return images[-1 - f].corners;
  Triangle corners;
  for (int k = 0; k < 3; ++k) corners[k] = inputVertex[mesh.corner(f, k)];
  if (isTurnedOver(t)) std::swap(corners[1], corners[2]);
  return corners;
}

Triangle Numbering::engineCorners(const TriangleMesh& mesh, int t) const {
  const int f = engineFace[t];
  if (f >= 0) {
    Triangle corners = mesh.faces[f];
    if (isTurnedOver(t)) std::swap(corners[1], corners[2]);
    return corners;
  }
  const FaceImage& image = images[-1 - f];
  if (image.isDuplicate) return {-1, -1, -1};
  Triangle corners;
  for (int k = 0; k < 3; ++k) corners[k] = engineVertex[image.corners[k]];
  // A split vertex has one part in each fan.
  for (const FacePiece& piece : image.pieces) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        if (piece.corners[static_cast<size_t>(j)] == Vec3::Unit(k)) {
          corners[k] = mesh.corner(piece.face, j);
        }
      }
    }
  }
  return corners;
}

SurfacePoint toEngine(const Numbering& numbering, const TriangleMesh& mesh, int inputFace,
                      const Vec3& bary) {
  SurfacePoint point = checkedPoint(numbering.inputFaceCount(), inputFace, bary);
  const int f = numbering.engineFace[inputFace];
  if (f >= 0) {
    point.face = f;
    if (numbering.isTurnedOver(inputFace)) std::swap(point.bary[1], point.bary[2]);
    return point;
  }
  const FaceImage& image = numbering.images[-1 - f];
  if (!image.pieces.empty()) return inPieces(image, point.bary);
  const Vec3 place = placeIn(image, point.bary);
  if (!image.beside.empty()) return nearestBeside(mesh, image, place);
  // The triangle has no faces at its own vertices; these would take precedence, since other parts
  // of the surface may be at the same place. So the mesh's nearest point counts if it lies at the
  // place up to the rounding of a file.
  SurfacePoint nearest = nearestPoint(mesh, place);
  const double distance = (position(mesh, nearest) - place).norm();
  if (distance <= kFloatRounding * boundingBoxDiagonal(mesh)) return nearest;
  throw Error(ErrorCode::kBadIndex, "face " + std::to_string(inputFace) +
                                        " was left out, as it has no area, and touches no other");
}

SurfacePoint toInput(const Numbering& numbering, const SurfacePoint& point) {
  const int t = numbering.inputFace[point.face];
  if (numbering.engineFace[t] == point.face) {
    SurfacePoint result{t, point.bary};
    if (numbering.isTurnedOver(t)) std::swap(result.bary[1], result.bary[2]);
    return result;
  }
  return clampedPoint(t, changeToInput(numbering, point.face, point.bary));
}

Vec3 changeToInput(const Numbering& numbering, int engineFace, const Vec3& change) {
  const int t = numbering.inputFace[engineFace];
  if (numbering.engineFace[t] == engineFace) {
    return numbering.isTurnedOver(t) ? Vec3(change[0], change[2], change[1]) : change;
  }
  const FacePiece& piece = pieceOf(numbering, engineFace);
  Vec3 result = Vec3::Zero();
  for (int k = 0; k < 3; ++k) result += change[k] * piece.corners[static_cast<size_t>(k)];
  return result;
}

}  // namespace karcher

#include "measures/gauss_bonnet.h"

#include <cmath>

#include "intrinsic/angles.h"
#include "mesh/disjoint_sets.h"

namespace karcher {

GaussBonnet gaussBonnet(const Geometry& geometry, const Arrangement& all, const Region& region) {
  const TriangleMesh& mesh = *geometry.mesh;
  const auto isIn = [&](int h) { return region[all.cell(h)] != 0; };
  GaussBonnet result;
  // The sets unite each half-edge with those that leave the same vertex of the region.
  DisjointSets corners(all.halfedgeCount());
  Array<double> angle(static_cast<size_t>(all.halfedgeCount()), 0);
  Array<uint8_t> isBorder(static_cast<size_t>(all.halfedgeCount()), 0);
  Array<uint8_t> onBorder(static_cast<size_t>(all.halfedgeCount()), 0);
  for (const Array<int>& loop : boundaryOf(all, region)) {
    for (const int h : loop) isBorder[h] = 1;
  }
  for (int h = 0; h < all.halfedgeCount(); ++h) {
    if (!isIn(h)) continue;
    const bool border = isBorder[h] != 0;
    // The characteristic counts edges; interior ones once.
    if (border || h < all.twin[h]) --result.euler;
    if (!border) corners.unite(h, all.next[all.twin[h]]);
  }
  for (int h = 0; h < all.halfedgeCount(); ++h) {
    if (!isIn(h)) continue;
    const int after = all.next[h];
    const int f = all.face(h);
    const Vec2 corner = placeIn(mesh, all.added, f, all.tail[after]);
    const Vec2 way = placeIn(mesh, all.added, f, all.head(after)) - corner;
    const Vec2 back = placeIn(mesh, all.added, f, all.tail[h]) - corner;
    // At the tip of a line the piece surrounds it.
    const double between = angleBetween(inFrame(geometry, f, way), inFrame(geometry, f, back));
    angle[corners.find(after)] += exactCross(way, back) > 0 ? between : 2 * kPi - between;
    if (isBorder[after] != 0) onBorder[corners.find(after)] = 1;
  }
  for (int h = 0; h < all.halfedgeCount(); ++h) {
    if (!isIn(h) || corners.find(h) != h) continue;
    ++result.euler;
    result.curvature += (onBorder[h] != 0 ? kPi : 2 * kPi) - angle[h];
  }
  // The number of holes of a piece reduces its Euler characteristic.
  Array<int> loopsOfPiece(static_cast<size_t>(all.pieceCount()), 0);
  Array<uint8_t> isSeen(static_cast<size_t>(all.halfedgeCount()), 0);
  for (int first = 0; first < all.halfedgeCount(); ++first) {
    if (!isIn(first) || isSeen[first] != 0) continue;
    ++loopsOfPiece[all.piece[first]];
    for (int h = first; isSeen[h] == 0; h = all.next[h]) isSeen[h] = 1;
  }
  for (const int loops : loopsOfPiece) {
    if (loops > 0) result.euler += 2 - loops;
  }
  return result;
}

}  // namespace karcher

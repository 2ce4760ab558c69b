#include "rcm/cells.h"

#include <algorithm>

namespace karcher {

CellPoint Cells::cutAt(const SurfacePoint& point) {
  const Vec3& b = point.bary;
  for (int k = 0; k < 3; ++k) {
    if (b[k] < 0.5) continue;
    const double onward = 2 * b[(k + 1) % 3];
    const double back = 2 * b[(k + 2) % 3];
    return {4 * point.face + k, Vec3(1 - onward - back, onward, back)};
  }
  return {4 * point.face + 3, Vec3(b[0] + b[1] - b[2], b[1] + b[2] - b[0], b[2] + b[0] - b[1])};
}

Vec3 Cells::toFaceWeights(int cell, const Vec3& bary) {
  const int k = cell % 4;
  if (k == 3) return Vec3(bary[0] + bary[2], bary[0] + bary[1], bary[1] + bary[2]) / 2;
  Vec3 result;
  result[k] = bary[0] + (bary[1] + bary[2]) / 2;
  result[(k + 1) % 3] = bary[1] / 2;
  result[(k + 2) % 3] = bary[2] / 2;
  return result;
}

SurfacePoint Cells::pointOnEdge(int h, double s) const {
  if (!cut_) return edgePoint(h, s);
  Vec3 bary = Vec3::Zero();
  bary[cornerOf(h)] = 1 - s;
  bary[cornerOf(next(h))] = s;
  return point(faceOf(h), bary);
}

SurfacePoint Cells::tailOf(int h) const {
  if (!cut_) return vertexPoint(mesh_, mesh_.tail(h));
  const int cell = faceOf(h);
  if (cell % 4 < 3 && cornerOf(h) == 0) return vertexPoint(mesh_, mesh_.corner(cell / 4, cell % 4));
  return pointOnEdge(firstAround(h), 0);
}

int Cells::firstAround(int h) const {
  if (!cut_) return mesh_.outgoing[mesh_.tail(h)];
  int first = h;
  for (int around = h;;) {
    const int t = twin(around);
    if (t < 0) return around;
    around = next(t);
    if (around == h) return first;
    first = std::min(first, around);
  }
}

int Cells::cutTwin(int h) const {
  const int cell = faceOf(h);
  const int face = cell / 4;
  const int k = cell % 4;
  if (k == 3) return 3 * (4 * face + (cornerOf(h) + 1) % 3) + 1;
  if (cornerOf(h) == 1) return 3 * (4 * face + 3) + (k + 2) % 3;
  // The cell's edge is half of one of the face's half-edges: the first half of the half-edge that
  // leaves corner k, or the second half of the half-edge that enters corner k.
  const bool first = cornerOf(h) == 0;
  const int t = mesh_.twin[3 * face + (first ? k : (k + 2) % 3)];
  if (t < 0) return -1;
  return first ? 3 * (4 * faceOf(t) + cornerOf(next(t))) + 2 : 3 * (4 * faceOf(t) + cornerOf(t));
}

}  // namespace karcher

#include "peers/intrinsic_triangulation.h"

#include <algorithm>

namespace karcher {
namespace {

/// The angle between sides b and c that lies opposite to side a.
double angleOpposite(double a, double b, double c) {
  return std::acos(std::clamp((b * b + c * c - a * a) / (2 * b * c), -1.0, 1.0));
}

/// The apex of h's face, in coordinates with the tail of h at the origin and its head on the
/// positive x axis.
Vec2 apexOver(const IntrinsicTriangulation& triangulation, int h) {
  const double base = triangulation.length[h];
  const double right = triangulation.length[next(h)];
  const double left = triangulation.length[previous(h)];
  return {(base * base + left * left - right * right) / (2 * base),
          doubleArea(triangulation, faceOf(h)) / base};
}

bool isDelaunay(const IntrinsicTriangulation& triangulation, int h) {
  // Rounding must not let two flips of a square's diagonal undo each other forever.
  constexpr double kTolerance = 1e-9;
  const int t = triangulation.twin[h];
  if (t < 0 || faceOf(t) == faceOf(h)) return true;
  return oppositeCotangent(triangulation, h) + oppositeCotangent(triangulation, t) >= -kTolerance;
}

/// Copies the tail, the length and the direction of half-edge `from` to `to`. The caller sets the
/// twins.
void moveHalfedge(IntrinsicTriangulation& triangulation, int from, int to) {
  triangulation.tail[to] = triangulation.tail[from];
  triangulation.length[to] = triangulation.length[from];
  triangulation.direction[to] = triangulation.direction[from];
}

/// The direction of the corner's other side at the tail of h. The corner lies counterclockwise from
/// h.
double directionAfterCorner(const IntrinsicTriangulation& triangulation, int h) {
  const int v = triangulation.tail[h];
  const double total = triangulation.geometry->totalAngle[v];
  const double direction = triangulation.direction[h] + cornerAngle(triangulation, h);
  const bool wraps = !triangulation.geometry->mesh->onBoundary[v] && direction >= total;
  return wraps ? direction - total : direction;
}

/// Replaces the edge from i to j between the faces i j k and j i l by the edge from l to k. The
/// faces become i l k and j k l, in which the half-edges k i and l j keep their indices.
void flipEdge(IntrinsicTriangulation& triangulation, int ij) {
  const int ji = triangulation.twin[ij];
  const int jk = next(ij);
  const int ki = previous(ij);
  const int il = next(ji);
  const int lj = previous(ji);
  const Vec2 k = apexOver(triangulation, ij);
  const Vec2 below = apexOver(triangulation, ji);
  const Vec2 l(triangulation.length[ij] - below.x(), -below.y());

  const auto moved = [&](int h) { return h == il ? ij : h == jk ? ji : h; };
  const int twinOfIl = moved(triangulation.twin[il]);
  const int twinOfJk = moved(triangulation.twin[jk]);
  const int tailK = triangulation.tail[ki];
  const int tailL = triangulation.tail[lj];
  moveHalfedge(triangulation, il, ij);
  moveHalfedge(triangulation, jk, ji);
  const int lk = jk;
  const int kl = il;
  triangulation.tail[lk] = tailL;
  triangulation.tail[kl] = tailK;
  triangulation.length[lk] = triangulation.length[kl] = (k - l).norm();
  triangulation.direction[lk] = directionAfterCorner(triangulation, lj);
  triangulation.direction[kl] = directionAfterCorner(triangulation, ki);

  triangulation.twin[ij] = twinOfIl;
  if (twinOfIl >= 0) triangulation.twin[twinOfIl] = ij;
  triangulation.twin[ji] = twinOfJk;
  if (twinOfJk >= 0) triangulation.twin[twinOfJk] = ji;
  triangulation.twin[lk] = kl;
  triangulation.twin[kl] = lk;
}

}  // namespace

IntrinsicTriangulation meshTriangulation(const Geometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  IntrinsicTriangulation triangulation;
  triangulation.geometry = &geometry;
  triangulation.tail.resize(static_cast<size_t>(mesh.halfedgeCount()));
  for (int h = 0; h < mesh.halfedgeCount(); ++h) triangulation.tail[h] = mesh.tail(h);
  triangulation.twin = mesh.twin;
  triangulation.length = geometry.edgeLength;
  triangulation.direction = geometry.cumulatedAngle;
  return triangulation;
}

int makeDelaunay(IntrinsicTriangulation& triangulation) {
  Array<int> queue;
  Array<uint8_t> queued(triangulation.tail.size(), 1);
  for (int h = 0; h < triangulation.tail.count(); ++h) queue.push_back(h);
  const int mostFlips = 100 * triangulation.tail.count();
  int flips = 0;
  while (!queue.empty() && flips < mostFlips) {
    const int h = queue.back();
    queue.pop_back();
    queued[h] = 0;
    if (isDelaunay(triangulation, h)) continue;
    const int t = triangulation.twin[h];
    flipEdge(triangulation, h);
    ++flips;
    for (const int changed : {h, next(h), previous(h), t, next(t), previous(t)}) {
      if (!queued[changed]) queue.push_back(changed);
      queued[changed] = 1;
    }
  }
  return flips;
}

double doubleArea(const IntrinsicTriangulation& triangulation, int f) {
  double a = triangulation.length[3 * f];
  double b = triangulation.length[3 * f + 1];
  double c = triangulation.length[3 * f + 2];
  // Heron's formula in the order of operations that W. Kahan gives for needles.
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return std::sqrt(std::max(product, 0.0)) / 2;
}

double cornerAngle(const IntrinsicTriangulation& triangulation, int h) {
  return angleOpposite(triangulation.length[next(h)], triangulation.length[h],
                       triangulation.length[previous(h)]);
}

double oppositeCotangent(const IntrinsicTriangulation& triangulation, int h) {
  const double a = triangulation.length[h];
  const double b = triangulation.length[next(h)];
  const double c = triangulation.length[previous(h)];
  // Rounding in a flip may leave a face without area, which must not make the weights infinite.
  const double area = std::max(doubleArea(triangulation, faceOf(h)), 1e-14 * (b * b + c * c));
  return (b * b + c * c - a * a) / (2 * area);
}

Complex vectorAtTail(const IntrinsicTriangulation& triangulation, int h) {
  const double scale = triangulation.geometry->angleScale[triangulation.tail[h]];
  return std::polar(triangulation.length[h], scale * triangulation.direction[h]);
}

Complex vectorAtHead(const IntrinsicTriangulation& triangulation, int h) {
  const int twin = triangulation.twin[h];
  if (twin >= 0) return vectorAtTail(triangulation, twin);
  const int v = triangulation.head(h);
  const Geometry& geometry = *triangulation.geometry;
  return std::polar(triangulation.length[h], geometry.angleScale[v] * geometry.totalAngle[v]);
}

}  // namespace karcher

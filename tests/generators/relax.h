#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

/// The area-weighted mean, for each vertex, of its triangles' centroids. A move of the vertices
/// there makes the tessellation more even (a step towards a centroidal one).
inline Array<Vec3> meanCentroids(const TriangleSoup& soup) {
  Array<Vec3> sum(soup.positions.size(), Vec3::Zero());
  Array<double> area(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles) {
    const Vec3& a = soup.positions[t[0]];
    const Vec3& b = soup.positions[t[1]];
    const Vec3& c = soup.positions[t[2]];
    const double weight = (b - a).cross(c - a).norm();
    for (const int v : t) {
      sum[v] += weight / 3 * (a + b + c);
      area[v] += weight;
    }
  }
  for (int v = 0; v < sum.count(); ++v) sum[v] /= area[v];
  return sum;
}

}  // namespace karcher

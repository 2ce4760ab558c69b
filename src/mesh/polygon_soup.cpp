#include "mesh/polygon_soup.h"

#include <utility>

#include "mesh/error.h"
#include "mesh/polygon.h"
#include "mesh/triangle_mesh.h"

namespace karcher {
namespace {

[[noreturn]] void throwUncut(const std::string& place, int corners) {
  const std::string face = place + ": the face with " + std::to_string(corners) + " corners ";
  if (corners > kMostPolygonCorners) {
    throw Error(ErrorCode::kDegenerateFace,
                face + "is too large: at most " + std::to_string(kMostPolygonCorners) + " are cut");
  }
  throw Error(ErrorCode::kDegenerateFace,
              face + "cannot be cut into triangles: it crosses itself or has no area");
}

/// Removes repetitions of a vertex that a polygon names several times in a row. Keeps at least
/// three corners. Returns whether it removed any.
bool takeOnce(Array<int>& corners) {
  Array<int> ring;
  for (const int v : corners) {
    if (ring.empty() || ring.back() != v) ring.push_back(v);
  }
  while (ring.count() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() == corners.size()) return false;
  while (ring.count() < 3) ring.push_back(int(ring.back()));
  corners = std::move(ring);
  return true;
}

/// A fan of triangles without area if all corners lie on a line; else empty.
Array<Triangle> fanOnALine(const Array<Vec3>& corners) {
  if (corners.count() > kMostPolygonCorners) return {};
  Array<Triangle> fan;
  for (int k = 2; k < corners.count(); ++k) {
    if (!isDegenerate(corners[0], corners[k - 1], corners[k])) return {};
    fan.emplace_back(0, k - 1, k);
  }
  return fan;
}

/// The two triangles of a quad that crosses itself, cut along its shorter diagonal; empty if one of
/// them has no area.
Array<Triangle> halves(const Array<Vec3>& corners) {
  if (corners.count() != 4) return {};
  const bool first =
      (corners[2] - corners[0]).squaredNorm() <= (corners[3] - corners[1]).squaredNorm();
  Array<Triangle> result;
  result.emplace_back(0, 1, first ? 2 : 3);
  result.emplace_back(first ? 0 : 1, 2, 3);
  for (const Triangle& t : result) {
    if (isDegenerate(corners[t[0]], corners[t[1]], corners[t[2]])) return {};
  }
  return result;
}

}  // namespace

CutPolygons cutPolygons(PolygonSoup polygons, bool mend,
                        const std::function<std::string(PolygonNumber)>& placeOf) {
  CutPolygons result;
  Array<Triangle>& triangles = result.soup.triangles;
  triangles.reserve(polygons.cornerCount.size());
  Array<Vec3> polygon;
  Array<int> ring;
  PolygonNumber number;
  int firstCount = 0;  // the number of corners of the first omitted face
  const int* corner = polygons.corners.data();
  // Marks the triangles of the previous face, however it was cut.
  const auto markTriangles = [&] {
    if (number.face < 0 || polygons.mark.empty()) return;
    result.mark.resize(triangles.size(), polygons.mark[number.face]);
  };
  for (const int count : polygons.cornerCount) {
    markTriangles();
    ++number.face;
    if (count == 3) {
      triangles.emplace_back(corner[0], corner[1], corner[2]);
      corner += count;
      continue;
    }
    ring.assign(corner, corner + count);
    corner += count;
    ++number.polygon;
    if (mend && takeOnce(ring)) {
      // If only one or two different corners remain, the importer counts the face as one with a
      // repeated corner.
      result.repeatedCorners += ring[1] != ring[2] ? 1 : 0;
      if (ring.count() == 3) {
        triangles.emplace_back(ring[0], ring[1], ring[2]);
        continue;
      }
    }
    polygon.clear();
    for (const int v : ring) polygon.push_back(polygons.positions[v]);
    Array<Triangle> cut = cutPolygon(polygon);
    if (cut.empty() && mend) cut = fanOnALine(polygon);
    if (cut.empty() && mend) cut = halves(polygon);
    if (cut.empty()) {
      if (!mend) throwUncut(placeOf(number), count);
      if (result.leftOut++ == 0) {
        result.firstLeftOut = number;
        firstCount = count;
      }
      continue;
    }
    for (const Triangle& t : cut) triangles.emplace_back(ring[t[0]], ring[t[1]], ring[t[2]]);
    ++result.polygonsCut;
  }
  markTriangles();
  if (triangles.empty() && result.leftOut > 0) {
    throwUncut(placeOf(result.firstLeftOut), firstCount);
  }
  result.soup.positions = std::move(polygons.positions);
  return result;
}

}  // namespace karcher

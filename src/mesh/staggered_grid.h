#pragma once

#include <algorithm>

#include "mesh/triangle_soup.h"

/// Grids with a shift by half a step in every second row, as in a tiling by equilateral triangles.
namespace karcher {

struct GridSize {
  int rows = 0;     ///< the number of steps along u, even
  int columns = 0;  ///< the number of steps along v
};

/// The size of a grid on a rectangle of uLength x vLength that has about the given number of
/// triangles, all nearly equilateral.
inline GridSize staggeredGridSize(double uLength, double vLength, int triangles) {
  // A row is as high as an equilateral triangle.
  const double rowsPerColumn = uLength / vLength * 2 / std::sqrt(3.0);
  const double columns = std::max(3.0, std::round(std::sqrt(triangles / 2.0 / rowsPerColumn)));
  const double rows = std::max(4.0, 2 * std::round(triangles / 4.0 / columns));
  return {static_cast<int>(rows), static_cast<int>(columns)};
}

/// A closed surface of the points point(u, v). The function is periodic in u and v with period 1; u
/// is a multiple of 1 / rows in [0, 1). The normals of the faces point along the cross product of
/// the derivatives with respect to u and v, in this order.
template <class Point>
TriangleSoup closedGrid(const GridSize& size, Point&& point) {
  TriangleSoup soup;
  for (int i = 0; i < size.rows; ++i) {
    for (int j = 0; j < size.columns; ++j) {
      soup.positions.push_back(
          point(static_cast<double>(i) / size.rows, (j + (i % 2 == 0 ? 0 : 0.5)) / size.columns));
    }
  }
  const auto vertex = [&](int i, int j) {
    return (i % size.rows) * size.columns + j % size.columns;
  };
  for (int i = 0; i < size.rows; ++i) {
    for (int j = 0; j < size.columns; ++j) {
      if (i % 2 == 0) {
        soup.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        soup.triangles.emplace_back(vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1));
      } else {
        soup.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        soup.triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  return soup;
}

/// A sheet from point(u, v) for u and v in [0, 1]. Shifted rows have half steps at their ends. The
/// normals of the faces point along the cross product of the derivatives with respect to v and u,
/// in this order.
template <class Point>
TriangleSoup openGrid(const GridSize& size, Point&& point) {
  TriangleSoup soup;
  Array<int> rowStart;
  for (int i = 0; i <= size.rows; ++i) {
    rowStart.push_back(soup.positions.count());
    const bool shifted = i % 2 != 0;
    for (int j = 0; j <= size.columns + (shifted ? 1 : 0); ++j) {
      const double step = shifted ? std::clamp(j - 0.5, 0.0, 1.0 * size.columns) : j;
      soup.positions.push_back(point(static_cast<double>(i) / size.rows, step / size.columns));
    }
  }
  for (int i = 0; i < size.rows; ++i) {
    const bool upper = i % 2 == 0;  // whether the shifted row is the upper one
    const int straight = rowStart[upper ? i : i + 1];
    const int shifted = rowStart[upper ? i + 1 : i];
    for (int j = 0; j <= size.columns; ++j) {
      const Triangle narrow(straight + j, shifted + j + 1, shifted + j);
      soup.triangles.push_back(upper ? narrow : Triangle(narrow[0], narrow[2], narrow[1]));
      if (j == size.columns) continue;
      const Triangle wide(straight + j, straight + j + 1, shifted + j + 1);
      soup.triangles.push_back(upper ? wide : Triangle(wide[0], wide[2], wide[1]));
    }
  }
  return soup;
}

}  // namespace karcher

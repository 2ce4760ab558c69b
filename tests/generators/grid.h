#pragma once

#include "mesh/types.h"

namespace karcher {

/// Triangles of a grid of columns x rows cells whose vertex (i, j) has number j (columns + 1) + i.
/// If diagonal(i, j) is true, a cell's cut starts at its (i, j) corner, otherwise at (i + 1, j).
template <class Diagonal>
Array<Triangle> gridTriangles(int columns, int rows, Diagonal&& diagonal) {
  Array<Triangle> triangles;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      const int b = a + 1;
      const int c = b + columns + 1;
      const int d = c - 1;
      if (diagonal(i, j)) {
        triangles.emplace_back(a, b, c);
        triangles.emplace_back(a, c, d);
      } else {
        triangles.emplace_back(a, b, d);
        triangles.emplace_back(b, c, d);
      }
    }
  }
  return triangles;
}

}  // namespace karcher

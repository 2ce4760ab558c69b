#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

struct Welding {
  Array<int> target;  ///< per vertex, the smallest vertex among those that it becomes one with
  int welded = 0;     ///< vertices that became another one
  int keptApart = 0;  ///< positions more that are shared, beyond one vertex each
};

/// Finds which vertices at exactly the same position (0 and -0 are the same) to weld: those that
/// two faces bring together along a common edge, two half-edges in opposite directions. Where more
/// faces meet along a pair of positions only their own vertices tell which belong together.
/// `order` lists the vertices that faces use, equal positions one after another (`mortonOrder`).
Welding findWelding(const TriangleSoup& soup, const Array<int>& order);

}  // namespace karcher

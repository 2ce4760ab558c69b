#include "curves/polygon/large_faces.h"

#include <algorithm>

#include "intrinsic/strip_path.h"

namespace karcher {

void findFacesAlongLegs(const Geometry& geometry, const RefinedPolygon& refined,
                        FacesAlongLegs& along) {
  along.faces.clear();
  along.longest.clear();
  along.begin.assign(1, 0);
  for (const SurfacePath& leg : refined.legs) {
    double longest = 0;
    int last = -1;
    for (int i = 1; i < leg.points.count(); ++i) {
      const int face = commonFace(*geometry.mesh, leg.points[i - 1], leg.points[i]);
      if (face < 0 || face == last) continue;
      last = face;
      along.faces.push_back(face);
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        longest = std::max(longest, geometry.edgeLength[h]);
      }
    }
    along.longest.push_back(longest);
    along.begin.push_back(along.faces.count());
  }
}

bool crossesLargerFace(const RefinedPolygon& refined, const SegmentLayout& piece,
                       const FacesAlongLegs& along) {
  double length = 0;
  double longest = 0;
  for (int k = 1; k < piece.points.count(); ++k) {
    const int leg = piece.points[k - 1];
    length += refined.legs[leg].length();
    longest = std::max(longest, along.longest[leg]);
  }
  return longest > length;
}

}  // namespace karcher

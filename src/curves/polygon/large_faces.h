#pragma once

#include "curves/polygon/levels.h"

namespace karcher {

/// The faces along the legs of a refined polygon. Reuse one to spare the allocations.
struct FacesAlongLegs {
  Array<int> faces;
  Array<int> begin;       ///< of leg k: faces[begin[k]] up to faces[begin[k + 1]]
  Array<double> longest;  ///< the longest edge of those faces, a leg
};

void findFacesAlongLegs(const Geometry& geometry, const RefinedPolygon& refined,
                        FacesAlongLegs& along);

/// Whether a piece of a refined polygon crosses a face that is larger than the piece: with an edge
/// longer than the legs of the piece together. It depends on the piece and on the faces that its
/// legs cross alone.
bool crossesLargerFace(const RefinedPolygon& refined, const SegmentLayout& piece,
                       const FacesAlongLegs& along);

}  // namespace karcher

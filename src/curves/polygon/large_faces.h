#pragma once

#include "curves/polygon/levels.h"

namespace karcher {

/// A reusable list of the faces along the legs of a refined polygon.
struct FacesAlongLegs {
  Array<int> faces;
  /// the index in `faces` of each leg's first face: leg k has the faces [begin[k], begin[k + 1])
  Array<int> begin;
  Array<double> longest;  ///< the longest edge of each leg's faces
};

void findFacesAlongLegs(const Geometry& geometry, const RefinedPolygon& refined,
                        FacesAlongLegs& along);

/// Whether a piece of a refined polygon crosses a larger face: a face with an edge longer than all
/// legs of the piece together. This depends only on the piece and on the faces that its legs cross.
bool crossesLargerFace(const RefinedPolygon& refined, const SegmentLayout& piece,
                       const FacesAlongLegs& along);

}  // namespace karcher

#pragma once

#include <optional>

#include "curves/polygon/levels.h"
#include "distance/oriented_box.h"

namespace karcher {

/// Scratch memory; reuse one to spare the allocations.
struct BoxWorkspace {
  Array<Vec3> normals;    ///< of the faces at the points
  Array<double> longest;  ///< edges of the faces at the points
  /// Those of the faces along leg k: corners[ofLegs[k]] up to corners[ofLegs[k + 1]].
  Array<Vec3> corners;
  Array<int> ofLegs;
  Array<int> legs;  ///< of the point whose box is made
  /// The pieces that blend point i: ofPoints[begin[i]] up to begin[i + 1].
  Array<int> begin;
  Array<int> ofPoints;
};

/// For each point of a refined polygon a box that holds all pieces that blend it, with room for the
/// faces around: where its field will be read (rcm/point_field.h). None where the pieces are long,
/// or do not tell directions. Depends on the points and the legs of these pieces alone. Writes to
/// `boxes`.
void boxPieces(const Geometry& geometry, const RefinedPolygon& refined, BoxWorkspace& workspace,
               Array<std::optional<OrientedBox>>& boxes);

}  // namespace karcher

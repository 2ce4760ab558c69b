#pragma once

#include <optional>

#include "curves/polygon/levels.h"
#include "distance/oriented_box.h"

namespace karcher {

/// For each point of a refined polygon a box that holds all pieces that blend it, with room for the
/// faces around: where its field will be read (rcm/point_field.h). None where the pieces are long,
/// or do not tell directions. Depends on the points and the legs of these pieces alone.
Array<std::optional<OrientedBox>> boxesOfPieces(const Geometry& geometry,
                                                const RefinedPolygon& refined);

}  // namespace karcher

#pragma once

#include <optional>

#include "distance/distance_solver.h"

/// Straight paths to vertices near by, each found on its own: a few of them cost less than a solver
/// that grows over all vertices between.
///
/// The faces that the line in space leads over are laid flat, the path is pulled tight between the
/// sides of this strip, and the strip is led round the other side of a vertex as long as that makes
/// the path shorter: as strip_path.h does, whose papers it follows, but in no memory but the stack,
/// and only to the length and the direction. Of several straight paths that is as a rule the
/// shortest. Of vertices up to 6 edges away none is a thousandth longer on stanford-bunny, .07 %
/// are on armadillo, and .2 % on spot, whose ears are thin, by a fourth at most.
namespace karcher {

/// A point that paths start from, in one of its faces.
struct SightSource {
  int face = 0;
  Vec3 position = Vec3::Zero();
  Vec3 x = Vec3::UnitX();  ///< the axes of the face's frame
  Vec3 y = Vec3::UnitY();
  Vec2 corners[3] = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  ///< of the face, from the point on
};
/// One face of a point in a face or on an edge; all faces around a point at a vertex.
using SightSources = Array<SightSource>;

/// What paths from a point need, written to `sources`, whose memory is used again.
void findSightSources(const Geometry& geometry, const SurfacePoint& point, SightSources& sources);

struct Sight {
  double distance = 0;
  Vec2 logVector = Vec2::Zero();  ///< -2 log_v(source), in the frame of the vertex
};

/// The path from a source to a vertex near by. None where no straight path is found, or where it is
/// so much longer than the line that another may be shorter. Depends on the source and the vertex
/// alone; on a plane it is the straight line.
std::optional<Sight> sightFrom(const Geometry& geometry, const SightSources& sources, int vertex);

}  // namespace karcher

#pragma once

#include <optional>

#include "distance/distance_solver.h"

/// Straight paths to vertices near by, each found on its own: a few of them cost less than a solver
/// that grows over all vertices between.
namespace karcher {

/// A point that paths start from, with what all of them need.
struct SightSource {
  int face = 0;
  bool isAtVertex = true;  ///< from which no path is found
  Vec3 position = Vec3::Zero();
  Vec3 x = Vec3::UnitX();  ///< the axes of the face's frame
  Vec3 y = Vec3::UnitY();
  Vec2 corners[3] = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  ///< of the face, from the point on
};
SightSource sightSource(const Geometry& geometry, const SurfacePoint& point);

struct Sight {
  double distance = 0;
  Vec2 logVector = Vec2::Zero();  ///< -2 log_v(source), in the frame of the vertex
};

/// The shortest path from a source to a vertex near by: the faces that a line in space leads over
/// are laid flat, and led round vertices as long as that makes the path in them shorter. Distances
/// and directions are exact. None where no such path is found, or where it is so much longer than
/// the line that another may be shorter. Depends on the source and the vertex alone.
std::optional<Sight> sightFrom(const Geometry& geometry, const SightSource& source, int vertex);

}  // namespace karcher

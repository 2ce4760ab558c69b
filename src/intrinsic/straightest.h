#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

/// Straightest geodesics: K. Polthier, M. Schmies, "Straightest Geodesics on Polyhedral Surfaces"
/// (1998). They are straight inside faces and across unfolded edges. At an interior vertex the path
/// continues so that it halves the total angle. At the boundary it stops, unless it can go straight
/// on from a boundary vertex.
namespace karcher {

enum class TraceStop {
  kComplete,  ///< the walk has its whole length
  kBoundary,  ///< the path met the boundary, with the length `remaining` left
  kLimit,     ///< the path crossed `maxCrossings` edges, with the length `remaining` left
};

/// The name of a stop in reports, such as "boundary".
const char* traceStopName(TraceStop stop);

struct StraightestOptions {
  int maxCrossings = 1'000'000;
};

/// The largest number of edges that the steps of a search may cross in total. A shortest path
/// visits a face at most once and crosses far fewer edges. A longer walk winds around the surface,
/// for example around the tip of a cone 1 wide and 1e5 high, where half the height takes a million
/// crossings.
int mostCrossingsOfSearch(const TriangleMesh& mesh);

struct StraightestPath {
  /// The path from the start to the end, of at least two points. Consecutive points lie in the face
  /// of the later one: a crossing of an edge appears in the face that the path leaves, and again in
  /// the face that it enters.
  SurfacePath path;
  double remaining = 0;  ///< the length that the walk did not reach
  TraceStop stop = TraceStop::kComplete;
  Vec2 direction =
      Vec2(1, 0);  ///< the unit direction of travel at the end, in the frame of the end's face
};

/// Walks from `start` along `vector`. The vector is in the frame of start.face, and its length is
/// the length to walk. From an edge or a vertex the vector may point out of the face. The walk then
/// follows it into the face to which it points, unfolded about that edge or vertex. Throws Error
/// kNotFinite if the vector is not finite.
StraightestPath traceStraightest(const Geometry& geometry, const SurfacePoint& start,
                                 const Vec2& vector, const StraightestOptions& options = {});

/// The same walk, written to an existing path.
void traceStraightest(const Geometry& geometry, const SurfacePoint& start, const Vec2& vector,
                      StraightestPath& path, const StraightestOptions& options = {});

/// Walks from a vertex in an unscaled direction (see geometry.h). At a boundary vertex a walk in a
/// direction off the surface stops at once. Throws Error kNotFinite if the direction or the length
/// is not finite.
StraightestPath traceFromVertex(const Geometry& geometry, int vertex, double direction,
                                double length, const StraightestOptions& options = {});
void traceFromVertex(const Geometry& geometry, int vertex, double direction, double length,
                     StraightestPath& path, const StraightestOptions& options = {});

}  // namespace karcher

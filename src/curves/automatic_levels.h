#pragma once

#include "curves/polygon/convexity.h"
#include "curves/polygon/deviation.h"
#include "curves/polygon/levels.h"

/// How many levels a curve takes that is asked for none:
///
/// - A curve is safe at some levels if all its pieces are: their centers of mass move continuously,
///   and turn little more than the surface (convexity.h).
/// - Where level 0 is safe, it is the curve of Mancinelli and Puppo, Eq. 4. If all levels lie
/// within
///   a tolerance of it (deviation.h), the curve takes as many as make it quickest, else none.
/// - Where level 0 is not safe, as on rough surfaces, the curve takes the fewest levels at which it
///   is, or as many as make it quickest.
///
/// All this follows from the control polygon and the faces that its legs cross, but for one thing:
/// level 0 takes shortest paths between the points to be those to which the legs are pulled tight.
/// On a tube that the legs go round they are not, and centers of mass jump to its other side.
namespace karcher {

/// Mean edges: how far levels may move a curve that is safe without them.
inline constexpr double kLevelsTolerance = 0.02;

/// Scratch memory; reuse one to spare the allocations.
struct LevelsWorkspace {
  ConvexityWorkspace convexity;
  DeviationWorkspace deviation;
  Array<double> weights;
  StripWorkspace strip;
  SurfacePath tight;
};

/// Whether all pieces of a polygon are safe; of the control polygon itself too, whose pieces are
/// the curve's segments.
bool isSafe(const Geometry& geometry, const RefinedPolygon& polygon, LevelsWorkspace& workspace);

/// How many levels make a polygon safe, by what the legs of the control polygon tell; at least 1
/// where a curve of the shape takes levels. Where the legs go round the rim of an ear, the curve
/// goes over it: the refined polygon may need more.
int levelsToSafety(const Geometry& geometry, const CurveShape& shape, int points,
                   const Array<SurfacePath>& legs);

/// How many levels make a curve quickest: until legs cross few edges. A piece's fields cost about
/// the square of the edges that its legs cross, and there are twice as many pieces a level.
int quickLevels(const CurveShape& shape, int points, const Array<SurfacePath>& legs);

/// In the mesh's units: how far, by estimate, levels move the curve of a control polygon at most.
/// The estimate is right to about a third of it; this is the upper end.
double levelsDeviation(const Geometry& geometry, const RefinedPolygon& polygon,
                       LevelsWorkspace& workspace);

/// The length of the way between two of a segment's points to which the legs are pulled tight.
double tightLength(const Geometry& geometry, const RefinedPolygon& polygon,
                   const SegmentLayout& segment, int from, int to, LevelsWorkspace& workspace);

/// As many levels as make legs twice as long as edges, if the work allows that, and at least two.
/// The averages then lie within a small fraction of an edge of the subdivision curve.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

#pragma once

#include "curves/polygon/convexity.h"
#include "curves/polygon/deviation.h"
#include "curves/polygon/levels.h"

/// The number of levels of a curve that does not set it:
///
/// - A curve is safe at some levels if all its pieces are: their centers of mass move continuously,
///   and turn little more than the surface does (convexity.h).
/// - Where level 0 is safe, it is the curve of Mancinelli and Puppo, Eq. 4. If all levels lie
///   within a tolerance of it (deviation.h), the curve takes the number that makes it quickest,
///   else none.
/// - Where level 0 is not safe, as on rough surfaces, the curve takes the fewest levels at which it
///   is, or more if that is quicker.
///
/// All this follows from the control polygon and the faces that its legs cross, with one exception:
/// level 0 assumes that the tightened legs are the shortest paths between their points. On a tube
/// that the legs go around they are not, and centers of mass jump to its other side.
namespace karcher {

/// The largest move by levels of a curve that is safe without them, in mean edges.
inline constexpr double kLevelsTolerance = 0.02;

/// Scratch memory, which can be reused.
struct LevelsWorkspace {
  ConvexityWorkspace convexity;
  DeviationWorkspace deviation;
  Array<double> weights;
  StripWorkspace strip;
  SurfacePath tight;
};

/// Whether all pieces of a polygon are safe. The polygon may be the control polygon itself, whose
/// pieces are the curve's segments.
bool isSafe(const Geometry& geometry, const RefinedPolygon& polygon, LevelsWorkspace& workspace);

/// The number of levels that make a polygon safe, judged by the legs of the control polygon; at
/// least 1 if a curve of the shape takes levels. If the legs go around the rim of an ear, the curve
/// crosses it, and the refined polygon may need more.
int levelsToSafety(const Geometry& geometry, const CurveShape& shape, int points,
                   const Array<SurfacePath>& legs);

/// Whether the fields of a curve with these levels are near ones (PointField::setPoint), as they
/// are where the pieces' points mostly see what is read of them: a piece's legs cross no more faces
/// than sight does. Farther away each value would be a path search, which costs as much as a
/// wavefront that finds all of them, so that a curve of two pieces on a fine mesh took minutes.
/// Where no more levels may be taken, fields are near in any case: so many wavefronts would not fit
/// into memory.
bool areFieldsNear(const CurveShape& shape, int points, const Array<SurfacePath>& legs, int levels);

/// The number of levels that makes a curve quickest, at which legs cross few edges and the points
/// of a piece are in sight of each other. A piece's fields cost about the square of the edges that
/// its legs cross, and each level doubles the number of pieces.
int quickLevels(const CurveShape& shape, int points, const Array<SurfacePath>& legs);

/// The estimated largest move of a control polygon's curve by levels, in the mesh's units. The
/// estimate is right to about a third; this is the upper end.
double levelsDeviation(const Geometry& geometry, const RefinedPolygon& polygon,
                       LevelsWorkspace& workspace);

/// The length of the path between two of a segment's points to which the legs are pulled tight.
double tightLength(const Geometry& geometry, const RefinedPolygon& polygon,
                   const SegmentLayout& segment, int from, int to, LevelsWorkspace& workspace);

/// The number of levels at which legs are twice as long as edges, but at least two, and no more
/// than the work allows. The averages then lie within a small fraction of an edge of the
/// subdivision curve.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

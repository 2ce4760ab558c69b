#pragma once

#include "curves/polygon/convexity.h"
#include "curves/polygon/deviation.h"
#include "curves/polygon/levels.h"

/// The number of levels of a curve that does not set it:
///
/// - A curve is safe at a number of levels if all its pieces are: their centers of mass move
///   continuously, and turn little more than the surface does (convexity.h).
/// - If level 0 is safe, it is the curve of Mancinelli and Puppo, Eq. 4. If the curves of all
///   levels lie within a tolerance of it (deviation.h), the curve takes the number of levels that
///   makes it quickest, else none.
/// - If level 0 is not safe, as on rough surfaces, the curve takes the fewest levels at which it is
///   safe, or more if that is quicker.
///
/// All this follows from the control polygon and the faces that its legs cross, with one exception:
/// level 0 assumes that the tightened legs are the shortest paths between their points. This fails
/// on a tube that the legs go around, where centers of mass jump to its other side.
namespace karcher {

/// The largest move by levels of a curve that is safe without them, in mean edges.
inline constexpr double kLevelsTolerance = 0.02;

/// Reusable scratch memory.
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

/// The number of levels that make a polygon safe, by the legs of the control polygon; at least 1 if
/// the shape takes levels. If the legs go around the rim of an ear that the curve crosses, the
/// refined polygon may need more.
int levelsToSafety(const Geometry& geometry, const CurveShape& shape, int points,
                   const Array<SurfacePath>& legs);

/// Whether the fields of a curve with these levels are near ones (PointField::setPoint). They are
/// if a piece's legs cross no more faces than the search in sight does: then the points mostly see
/// the vertices at which their fields are evaluated. At larger distances each value would take a
/// path search, as expensive as a wavefront that finds all values; a curve of two pieces on a fine
/// mesh took minutes. If the curve can take no more levels, fields are near in any case, since so
/// many wavefronts would not fit into memory.
bool areFieldsNear(const CurveShape& shape, int points, const Array<SurfacePath>& legs, int levels);

/// The number of levels of the quickest curve: its legs cross few edges, and the points of a piece
/// are in sight of each other. A piece's fields cost about the square of the edges that its legs
/// cross, and each level doubles the number of pieces.
int quickLevels(const CurveShape& shape, int points, const Array<SurfacePath>& legs);

/// An estimate of the largest move of a control polygon's curve by levels, in the mesh's units. It
/// is right to about a third, and this is the upper end.
double levelsDeviation(const Geometry& geometry, const RefinedPolygon& polygon,
                       LevelsWorkspace& workspace);

/// The length of the geodesic to which the legs between two of a segment's points are pulled tight.
double tightLength(const Geometry& geometry, const RefinedPolygon& polygon,
                   const SegmentLayout& segment, int from, int to, LevelsWorkspace& workspace);

/// The number of levels at which legs are twice as long as edges, but at least two, and no more
/// than the work limit allows. Their averages lie within a small fraction of an edge of the
/// subdivision curve.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

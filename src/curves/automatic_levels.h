#pragma once

#include "curves/polygon/convexity.h"
#include "curves/polygon/deviation.h"
#include "curves/polygon/levels.h"

/// The number of levels of a curve whose options do not set it:
///
/// - A curve is safe at a number of levels if all its pieces are safe: their centers of mass move
///   continuously, and turn little more than the surface does (convexity.h).
/// - If level 0 is safe, its curve is the one of Mancinelli and Puppo, Eq. 4. If levels move it by
///   no more than a tolerance (deviation.h), the curve takes the number of levels with which
///   tracing is fastest; otherwise it takes none.
/// - If level 0 is not safe, for instance on a rough surface, or if the frames of vertices turn the
///   fields of level 0, the curve takes the fewest levels at which it is safe, but at least one, or
///   more if tracing is then faster.
///
/// These decisions use only the legs of the polygons and the faces that the legs cross, with two
/// exceptions at level 0. A traced curve with bridges is not safe. And the legs between two points,
/// pulled tight, must be a shortest path, which only distance fields can tell: if the legs go
/// around a tube, a shorter path may go around its other side, and centers of mass jump to it.
namespace karcher {

/// The largest distance, in mean edges, by which levels may move a curve that is safe at level 0.
inline constexpr double kLevelsTolerance = 0.02;

/// Reusable scratch memory.
struct LevelsWorkspace {
  ConvexityWorkspace convexity;
  DeviationWorkspace deviation;
  Array<double> weights;
  SegmentLayout unfolded;
  StripWorkspace strip;
  SurfacePath tight;
};

/// Whether all pieces of a polygon are safe. The polygon may be the control polygon itself, whose
/// pieces are the curve's segments.
bool isSafe(const Geometry& geometry, const RefinedPolygon& polygon, LevelsWorkspace& workspace);

/// Whether a face along the legs has a turned frame (hasTurnedFrame). The fields of level 0 rely on
/// these frames. Near fields do not where paths are straight (FieldBlend).
bool areFramesTurned(const Geometry& geometry, const Array<SurfacePath>& legs);

/// The number of levels after which a polygon is probably safe, estimated from the detail along the
/// control polygon's legs. It is at least 1 if the shape takes levels. The refined polygon may need
/// more, for instance if the legs go around the rim of an ear and the curve crosses the ear.
int levelsToSafety(const Geometry& geometry, const CurveShape& shape, int points,
                   const Array<SurfacePath>& legs);

/// Whether the fields of a curve with these levels are near fields (PointField::setPoint). At level
/// 0 they are not. At other levels they are if the legs of a piece cross at most kMostFacesOfSight
/// faces, since the piece's points then see most of the vertices at which the fields are evaluated.
/// At larger distances each value would need a path search, which costs as much as a wavefront that
/// finds all values: on a fine mesh, a curve of two pieces took minutes. If the curve can take no
/// more levels, its fields are near in any case, since so many wavefronts would not fit into
/// memory.
bool areFieldsNear(const CurveShape& shape, int points, const Array<SurfacePath>& legs, int levels);

/// The number of levels with which tracing is fastest. At this level the legs cross few edges, and
/// the points of a piece see each other. The cost of a piece's fields grows with about the square
/// of the number of edges that its legs cross, and each level doubles the number of pieces.
int quickLevels(const CurveShape& shape, int points, const Array<SurfacePath>& legs);

/// An upper bound on the distance, in the mesh's units, by which levels move the curve of a control
/// polygon. It includes a margin, since the underlying estimate may be a third too low.
double levelsDeviation(const Geometry& geometry, const RefinedPolygon& polygon,
                       LevelsWorkspace& workspace);

/// The length of the legs between two points of a segment after they are pulled tight to a
/// geodesic.
double tightLength(const Geometry& geometry, const RefinedPolygon& polygon,
                   const SegmentLayout& segment, int from, int to, LevelsWorkspace& workspace);

/// The number of levels after which no leg is longer than two mean edges. It is at least 2 and at
/// most what the limit of work allows, or 0 if this limit does not allow 2 levels. At this level,
/// averages of two points lie within a small fraction of an edge from the subdivision curve.
int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs);

}  // namespace karcher

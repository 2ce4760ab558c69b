#pragma once

#include "curves/polygon/levels.h"

/// Whether centers of mass along a control polygon are safe: whether they move continuously, and no
/// more roughly than the surface itself. Told by the curvature of the faces that the polygon's legs
/// cross, without a distance field.
namespace karcher {

/// Scratch memory; reuse one to spare the allocations.
struct ConvexityWorkspace {
  // Along the legs of one piece.
  Array<double> places;       ///< lengths from the first point at which a face begins or ends
  Array<double> curvatures;   ///< per area, of the face after each place but the last
  Array<double> points;       ///< the places of the piece's points
  Array<double> convexities;  ///< by points: of their squared distances at each place
  Array<double> weights;
};

/// Gaussian curvature per area of a face: of each corner's vertex its share of the angle defect,
/// by the angles there.
double curvatureOf(const Geometry& geometry, int face);

/// The least second derivative, across the legs, of the energies whose minima are the points of a
/// piece, as a part of what it is on the plane. While it is positive the minima move continuously.
///
/// Half the squared distance from a point has the second derivative d J'(d) / J(d) across a
/// geodesic at the distance d, where J is the Jacobi field with J(0) = 0, J'(0) = 1, J'' = -K J (M.
/// P. do Carmo, "Riemannian Geometry", chapter 5). Here the legs stand for the geodesics, and K is
/// the curvature of the faces that they cross.
double leastConvexity(const Geometry& geometry, const Array<SurfacePath>& legs,
                      const SegmentLayout& piece, const Array<double>& pointWeights,
                      ConvexityWorkspace& workspace);

/// Radians: what of the curvature along a leg is detail, by which faces next to each other differ,
/// times the square of the leg's length. So much more than the surface does a center of mass turn
/// that sees the leg. It vanishes with the edges on a smooth surface, and grows on a rough one.
double detailAlong(const Geometry& geometry, const SurfacePath& leg);

}  // namespace karcher

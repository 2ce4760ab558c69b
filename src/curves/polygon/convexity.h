#pragma once

#include "curves/polygon/levels.h"

/// Safety of centers of mass along a control polygon: they are safe if they move continuously, and
/// turn little more than the surface does. The functions here decide this by the curvature of the
/// faces that the polygon's legs cross, without a distance field.
namespace karcher {

/// Reusable scratch memory.
struct ConvexityWorkspace {
  // Data along the legs of one piece.
  Array<double> places;      ///< the lengths along the legs at which faces begin or end
  Array<double> curvatures;  ///< the curvatures per area of the faces between the places
  Array<double> points;      ///< the places of the piece's points
  Array<double>
      convexities;  ///< for each point, the convexities of its squared distance at each place
  Array<double> weights;
};

/// The Gaussian curvature per area of a face. Each corner contributes a share of its vertex's angle
/// defect, in proportion to the face's angle there; vertices on the boundary contribute nothing.
double curvatureOf(const Geometry& geometry, int face);

/// The points of a piece are minima of energies. The function returns the least second derivative
/// of these energies across the legs, relative to its value in the plane. As long as it is
/// positive, the minima move continuously.
///
/// Half the squared distance from a point has the second derivative d J'(d) / J(d) across a
/// geodesic at the distance d, where J is the Jacobi field with J(0) = 0, J'(0) = 1, J'' = -K J (M.
/// P. do Carmo, "Riemannian Geometry", chapter 5). Here the legs replace the geodesics, and K is
/// the curvature of the faces that they cross.
double leastConvexity(const Geometry& geometry, const Array<SurfacePath>& legs,
                      const SegmentLayout& piece, const Array<double>& pointWeights,
                      ConvexityWorkspace& workspace);

/// The detail along a leg, in radians: the mean difference between the curvatures of adjacent
/// faces, times the square of the leg's length; 0 for a leg of few faces. A curve of centers of
/// mass that see the leg turns by this angle more than the surface does. As edges become shorter,
/// the detail tends to zero on a smooth surface, and grows on a rough one.
double detailAlong(const Geometry& geometry, const SurfacePath& leg);

}  // namespace karcher

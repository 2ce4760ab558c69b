#pragma once

#include "curves/polygon/leg_average.h"

/// Refinements of B-splines and Bezier curves with known legs (knot_insertion.h), by averages on
/// the legs instead of shortest paths. New legs are parts of old ones; between points on two legs,
/// the parts are pulled tight.
namespace karcher {

/// A control polygon with its legs: one from each point to the next, and for a closed curve also
/// from the last to the first. If there are no legs, all averages are along shortest paths.
struct PolygonWithLegs {
  ControlPolygon polygon;
  Array<SurfacePath> legs;
};

/// As in knot_insertion.h. A closed curve of fewer points than its degree loses its legs.
int insertKnot(const Geometry& geometry, PolygonWithLegs& whole, double u);
PolygonWithLegs partBefore(const Geometry& geometry, PolygonWithLegs open, double u);
PolygonWithLegs partAfter(const Geometry& geometry, PolygonWithLegs open, double u);
PolygonWithLegs cutOpen(const Geometry& geometry, PolygonWithLegs closed, double u);

/// The Bezier polygon with its degree raised by one.
LeggedPolygon elevated(const Geometry& geometry, const LeggedPolygon& bezier);

/// Writes the parts of a leg before and after the part t of its length. If a near point `cut` is
/// given, both are led to it; otherwise they meet on the leg. A part that cannot be led there has
/// no points.
void cutLeg(const Geometry& geometry, const SurfacePath& leg, double t, const SurfacePoint* cut,
            SurfacePath& before, SurfacePath& after);

}  // namespace karcher

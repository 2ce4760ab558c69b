#pragma once

#include "distance/distance_solver.h"
#include "regions/region.h"

/// Voronoi diagrams: the surface, divided into cells. A cell holds points with the same nearest
/// site. The package `karcher/statistics` has the same function under the same name.
namespace karcher {

struct VoronoiDiagram {
  /// The number of the nearest site for each vertex, or -1 for unreachable vertices. If several
  /// sites are equally near, the lowest number counts.
  Array<int> nearest;
  Array<double> areas;  ///< the area of each site's cell, in squared units of the mesh
  /// The surface, divided by lines. On a line two sites are equally near, and all other sites are
  /// farther away.
  Arrangement arrangement;
  /// The nearest site for each cell of the arrangement, or -1 for an unreachable cell. A site may
  /// have several cells.
  Array<int> siteOfCell;
};

/// The Voronoi diagram of sites. For a site with several points, the nearest point counts.
///
/// In every triangle, squared distances are interpolated linearly between the vertices. So the
/// lines are exact on a plane, up to the grid of the arrangement (regions/grid.h). On smooth
/// surfaces their error is of second order in the length of edges. Each point takes one field of
/// the solver's distances. If sites coincide, the first site has the cell, and the other sites have
/// empty cells.
///
/// Throws Error kTooFewPoints without sites and for a site without points, and what the solver
/// throws.
VoronoiDiagram voronoi(const Geometry& geometry, DistanceSolver& solver,
                       const Array<Array<SurfacePoint>>& sites);

/// The cell of a site as a region of the diagram's arrangement, for its boundary (region.h), its
/// centroid (centroid.h) and booleans. Throws Error kBadIndex if the diagram has no such site.
Region cellOfSite(const VoronoiDiagram& diagram, int site);

}  // namespace karcher

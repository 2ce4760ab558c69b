#pragma once

#include <memory>
#include <string>

#include "intrinsic/geometry.h"

/// Random drawings on surfaces of genus 0 to 3 and with rims, and the properties that their cells
/// and regions must have for any paths.
namespace karcher {

struct RegionSurface {
  RegionSurface(std::string itsName, TriangleMesh itsMesh);
  RegionSurface(const RegionSurface&) = delete;
  RegionSurface& operator=(const RegionSurface&) = delete;

  std::string name;
  TriangleMesh mesh;
  Geometry geometry;
  Array<int> rim;  ///< the half-edges without a twin
};

/// Spheres, tori, plates with two holes and surfaces of genus 3, even and uneven, each whole and
/// without some of its vertices; and sheets.
Array<std::unique_ptr<RegionSurface>> regionSurfaces();

/// Findings, summed over drawings.
struct RegionTally {
  int drawings = 0;
  int paths = 0;
  int cells = 0;
  int regions = 0;    // regions that sets of paths bound
  int unbounded = 0;  // sets of paths that bound no region
  int points = 0;
  double largestAreaError = 0;    // the error of the cells' sum, as a part of the surface's area
  double largestBonnetError = 0;  ///< the error of a region's curvature and turns
  Array<std::string> faults;      ///< the faults, as sentences
};

/// Draws closed polygons, walks along edges and the rim, stretches of one another, copies at less
/// or more than the distance of merging, and paths from rim to rim or into the open. Checks the
/// areas of cells, the theorem of Gauss and Bonnet, and the sets of paths that bound regions. For a
/// hundred points it checks the regions that contain them, by counts of crossings face by face
/// without the arrangement. Everything depends on the seed alone.
void fuzzRegions(const RegionSurface& surface, uint64_t seed, RegionTally& tally);

}  // namespace karcher

#pragma once

#include <string>

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

/// Meshes that are hard for solvers of geodesic distances: with vertices of many or of acute
/// corners, thin and obtuse triangles, sharp edges, tight tubes, and coordinates far from 1 and
/// from the origin. Each is the same in every run, and has some 500 to 10,000 triangles.
namespace karcher {

struct GalleryMesh {
  std::string name;
  TriangleSoup soup;
  /// Whether the mesh is a convex piece of a plane, where distances are straight.
  bool isFlat = false;
};

Array<GalleryMesh> gallery();

/// A sheet of some 3,000 triangles whose kind, noise (.05 to .6 of an edge), stretch (1 to 30) and
/// shear (0 to 4) are random.
GalleryMesh randomSheet(uint64_t seed);

/// The mesh of that name. Throws std::runtime_error for an unknown name.
TriangleMesh galleryMesh(const std::string& name);

/// A sheet folded along random lines, one after another, upwards and downwards: creases cross, and
/// all of them cut through triangles.
TriangleSoup crumpledSheet(int triangles, int folds, uint64_t seed);

/// A square of `side` x `side` squares, each a fan of 4 q triangles around its middle. `jitter`
/// moves middles, and the vertices along sides, by that part of their free space.
TriangleSoup fanSquares(int side, int q, double jitter, uint64_t seed);

/// A closed tube of the given radius around a circle of radius 1, in `around` x `along` quads with
/// parallel diagonals.
TriangleSoup ringTube(double radius, int around, int along);

/// The surface of `columns` x `rows` x 1 unit cubes without those at odd places in both directions,
/// each square cut in two: a plate with square holes.
TriangleSoup plateWithHoles(int columns, int rows);

/// A fan of `valence` triangles around a vertex `height` above its rim, inside `rings` rings of
/// quads: a disk for height 0, otherwise a cone.
TriangleSoup wheel(int valence, int rings, double height);

/// A flat grid of x = 10^(k / 2), k = 0, ..., `columns`, and y = 0, ..., `rows`.
TriangleSoup wideGrid(int columns, int rows);

}  // namespace karcher

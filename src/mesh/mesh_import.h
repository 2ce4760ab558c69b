#pragma once

#include <string>
#include <string_view>

#include "mesh/numbering.h"
#include "mesh/obj_reader.h"
#include "mesh/polygon_soup.h"
#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

/// Import of a caller's mesh: checks, repairs, and new numbers along a Morton curve, so that
/// neighbours on the surface are neighbours in memory.
namespace karcher {

struct Repair {
  enum class Kind {
    kTriangulated,    ///< polygons cut into triangles
    kLeftOut,         ///< omitted faces that have fewer than three corners or cannot be cut
    kContracted,      ///< vertices merged with a neighbour along an edge without length
    kWelded,          ///< vertices at the same place that were merged
    kKeptApart,       ///< vertices at the same place that stay apart, since parts only touch there
    kRepeatedCorner,  ///< omitted faces with the same vertex at two corners
    kDuplicate,       ///< omitted faces that repeat another face
    kNoArea,          ///< faces whose corners lie on a line, removed by flips
    kTurnedOver,      ///< turned faces, which disagreed with their neighbours
    kBranching,       ///< separated edges with more than two faces
    kBowTie,          ///< split vertices that joined several fans of faces
    kDropped,         ///< omitted vertices that no face uses
  };
  Kind kind;
  int count = 0;
  std::string sentence;
};

/// The name of a kind of repair in reports, such as "welded".
const char* repairName(Repair::Kind kind);

struct ImportOptions {
  /// Whether to repair. If false, the import rejects meshes that are not manifold surfaces, and
  /// welds only vertices at exactly the same place.
  bool repair = true;
  /// The import welds vertices up to this distance from each other, in the mesh's units, but at
  /// most up to a third of the shortest edge at either vertex. 0 welds nothing. A negative value
  /// stands for the smaller of 1e-6 of the diagonal and 1 % of the shortest edge at either vertex.
  double weld = -1;
};

struct ImportedMesh {
  TriangleMesh mesh;
  Numbering numbering;
  /// The positions of the dropped input vertices, in the input's order.
  Array<Vec3> droppedPositions;
  Array<Repair> repairs;
};

/// Repairs a mesh, in this order, and counts each kind in `repairs`:
/// - contracts edges of at most 1e-14 of the diagonal, or 1e-12 of their face's longest edge;
/// - welds boundary vertices where two faces lie along each other (`closeSeams`). This closes the
///   seams of unwelded files; parts that only touch stay apart;
/// - omits faces with a repeated corner, and duplicates;
/// - flips the longest edges of faces without area (`flipFlatTriangles`);
/// - turns faces over until they agree, separates edges with more than two faces, and splits
///   vertices that join several fans (`connectRepaired`).
///
/// A mesh without such defects keeps its positions and faces, to the last bit; only their order
/// changes. Throws what `buildMesh` throws, and Error: kNotOrientable; kBadArgument if the weld is
/// not a number. Errors name the caller's vertices and triangles. Vertices that no face uses may
/// have any position.
ImportedMesh importMesh(TriangleSoup soup, const ImportOptions& options = {});

/// Cuts polygons as `cutPolygons` does, and imports the triangles. Face numbers count triangles,
/// not polygons. Throws what both functions throw, and kBadArgument if a face has fewer than 3
/// corners, or if the counts do not sum to the number of `corners`.
ImportedMesh importPolygons(PolygonSoup polygons, const ImportOptions& options = {});

/// Imports the result of `readObj`. Face numbers count triangles, not polygons. Throws what
/// `importMesh` throws.
ImportedMesh importObj(ObjContents contents, const ImportOptions& options = {});
/// Reads an OBJ file's content and imports it.
ImportedMesh importObj(std::string_view bytes, const ImportOptions& options = {});

}  // namespace karcher

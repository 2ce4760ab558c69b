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
    kTriangulated,    ///< polygons were cut into triangles
    kLeftOut,         ///< faces of fewer than three corners, or that cannot be cut, were omitted
    kContracted,      ///< vertices were merged with neighbours at the other ends of edges without
                      ///< length
    kWelded,          ///< vertices at the same place became one
    kKeptApart,       ///< vertices at the same place were kept apart, since parts only touch there
    kRepeatedCorner,  ///< faces with the same vertex at two corners were omitted
    kDuplicate,       ///< faces that repeat another were omitted
    kNoArea,          ///< faces whose corners lie on a line were flipped away
    kTurnedOver,      ///< faces that disagreed with their neighbours were turned over
    kBranching,       ///< edges of more than two faces were separated
    kBowTie,          ///< vertices between several fans of faces were split
    kDropped,         ///< vertices that no face uses were omitted
  };
  Kind kind;
  int count = 0;
  std::string sentence;
};

/// The name of a kind of repair in reports: "welded".
const char* repairName(Repair::Kind kind);

struct ImportOptions {
  /// Whether to repair. If false, the import rejects meshes that are not manifold surfaces, and
  /// welds only vertices at exactly the same place.
  bool repair = true;
  /// The largest distance between vertices that the import welds, in the mesh's units. 0 welds only
  /// equal positions. A negative value stands for the smaller of 1e-6 of the diagonal and 1 % of
  /// the shortest edge at either vertex.
  double weld = -1;
};

struct ImportedMesh {
  TriangleMesh mesh;
  Numbering numbering;
  /// The positions of the input vertices that were dropped, in the input's order.
  Array<Vec3> droppedPositions;
  Array<Repair> repairs;
};

/// Repairs a mesh, in this order, and counts each kind in `repairs`:
/// - edges of at most 1e-14 of the diagonal, or 1e-12 of their face's longest edge, are contracted;
/// - vertices on boundaries are welded where two faces lie along each other (`closeSeams`), which
///   closes the seams of unwelded files; parts that only touch stay apart;
/// - faces with a repeated corner, and duplicates, are omitted;
/// - the longest edges of faces without area are flipped (`flipFlatTriangles`);
/// - faces are turned over until they agree, edges of more than two faces are separated, and
///   vertices between several fans are split (`connectRepaired`). A mesh without such defects is
///   unchanged, to the last bit.
///
/// Throws Error as `buildMesh` does, and kNotOrientable, kBadArgument (a weld that is not finite);
/// errors name the caller's vertices and triangles. Vertices that no face uses may have any
/// position.
ImportedMesh importMesh(TriangleSoup soup, const ImportOptions& options = {});

/// Cuts polygons as `cutPolygons` does, and imports the triangles. Face numbers are those of
/// triangles. Throws what both throw, and kBadArgument for counts of corners below 3, or whose sum
/// is not the number of `corners`.
ImportedMesh importPolygons(PolygonSoup polygons, const ImportOptions& options = {});

/// Imports the result of `readObj`. Face numbers are those of triangles. Throws what `importMesh`
/// throws.
ImportedMesh importObj(ObjContents contents, const ImportOptions& options = {});
/// Reads an OBJ file's content and imports it.
ImportedMesh importObj(std::string_view bytes, const ImportOptions& options = {});

}  // namespace karcher

#pragma once

#include <string>
#include <string_view>

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

/// The mesh that the engine works on, made of what a caller has: checked, repaired, and renumbered
/// along a Morton curve, so that neighbours on the surface are neighbours in memory.
namespace karcher {

/// Between the caller's (input) numbers and the engine's. The corners of a face keep their order,
/// so barycentric weights are the same on both sides.
struct Numbering {
  Array<int> engineVertex;  ///< per input vertex; welded ones share a number, dropped ones have -1
  Array<int> inputVertex;   ///< per engine vertex, the first input vertex that became it
  Array<int> engineFace;    ///< per input triangle
  Array<int> inputFace;     ///< per engine face
};

struct Repair {
  enum class Kind {
    kTriangulated,  ///< polygons were cut into triangles
    kWelded,        ///< vertices at the same position became one
    kKeptApart,     ///< vertices at the same position stayed several: parts only touch there
    kDropped,       ///< vertices that no face uses were left out
  };
  Kind kind;
  int count = 0;  ///< of polygons cut, of vertices welded, kept apart or dropped
  std::string sentence;
};

/// The name of a kind of repair in reports: "welded".
const char* repairName(Repair::Kind kind);

struct ImportedMesh {
  TriangleMesh mesh;
  Numbering numbering;
  /// Per input vertex that was dropped, in the input's order, where it was.
  Array<Vec3> droppedPositions;
  Array<Repair> repairs;
};

/// Vertices at exactly the same position are welded where two boundary edges meet along their whole
/// length, which closes the seams of unwelded files; parts that only touch stay apart, since one
/// vertex or edge for both would not be manifold.
/// Throws Error as `buildMesh` does; errors name the caller's vertices and triangles.
ImportedMesh importMesh(TriangleSoup soup);

/// Reads an OBJ file's content and imports it; face numbers count triangles. Throws as `readObj`
/// and `importMesh` do.
ImportedMesh importObj(std::string_view bytes);

}  // namespace karcher

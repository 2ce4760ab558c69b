#include "mesh/mesh_import.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "mesh/mesh_repair.h"
#include "mesh/positions.h"

namespace karcher {
namespace {

struct Words {
  const char* name;
  const char* one;   ///< the words after "1"
  const char* many;  ///< the words after another number
};

/// The words for each kind of repair, in the singular and in the plural.
constexpr std::array<Words, 12> kWords = {{
    {"triangulated", "polygon was cut into triangles", "polygons were cut into triangles"},
    {"leftOut", "face was left out: it has fewer than three corners, crosses itself or has no area",
     "faces were left out: they have fewer than three corners, cross themselves or have no area"},
    {"contracted",
     "vertex was merged with a neighbour: the edge between them was at most 1e-14 of the diagonal, "
     "or 1e-12 of its face's longest edge",
     "vertices were merged with a neighbour: the edge between them was at most 1e-14 of the "
     "diagonal, or 1e-12 of its face's longest edge"},
    {"welded", "vertex was welded to another at the same position",
     "vertices were welded to another at the same position"},
    {"keptApart", "vertex at the position of another stayed apart, where no edge joins their faces",
     "vertices at the position of another stayed apart, where no edge joins their faces"},
    {"repeatedCorner", "face with one vertex at two corners was left out",
     "faces with one vertex at two corners were left out"},
    {"duplicate", "face at the place of another was left out",
     "faces at the place of another were left out"},
    {"noArea", "face without area, its corners on a line, was flipped away",
     "faces without area, their corners on a line, were flipped away"},
    {"turnedOver", "face was turned over to agree with its neighbours",
     "faces were turned over to agree with their neighbours"},
    {"branching",
     "edge had more than two faces: the two of the widest angle stayed together, the others were "
     "separated",
     "edges had more than two faces: the two of the widest angle stayed together, the others were "
     "separated"},
    {"bowTie", "vertex between several fans of faces became one for each",
     "vertices between several fans of faces became one for each"},
    {"dropped", "vertex that no face uses was left out",
     "vertices that no face uses were left out"},
}};

const Words& wordsOf(Repair::Kind kind) { return kWords[static_cast<size_t>(kind)]; }

/// Counts of the repairs of polygons.
struct CutRepairs {
  int polygonsCut;
  int repeatedCorners;
  int leftOut;
  std::string firstLeftOut;  ///< the place of the first omitted face
};

void addRepairs(const CutRepairs& cut, Array<Repair>& repairs) {
  const auto add = [&](Repair::Kind kind, int count, const std::string& more = {}) {
    if (count == 0) return;
    auto place = std::find_if(repairs.begin(), repairs.end(),
                              [&](const Repair& repair) { return repair.kind >= kind; });
    if (place != repairs.end() && place->kind == kind) {
      *place = repairOf(kind, place->count + count);
    } else {
      place = repairs.insert(place, repairOf(kind, count));
    }
    place->sentence += more;
  };
  add(Repair::Kind::kTriangulated, cut.polygonsCut);
  add(Repair::Kind::kLeftOut, cut.leftOut, " (the first: " + cut.firstLeftOut + ")");
  add(Repair::Kind::kRepeatedCorner, cut.repeatedCorners);
}

/// Checks that each face has at least 3 corners, that the sum of these counts is the number of
/// given corners, and that each corner is a vertex with a finite position.
void checkFaces(const PolygonSoup& polygons) {
  int64_t corners = 0;
  for (int face = 0; face < polygons.cornerCount.count(); ++face) {
    const int count = polygons.cornerCount[face];
    if (count < 3) {
      throw Error(ErrorCode::kBadArgument, "face " + std::to_string(face) +
                                               " must have at least 3 corners, not " +
                                               std::to_string(count));
    }
    corners += count;
  }
  if (corners != polygons.corners.count()) {
    throw Error(ErrorCode::kBadArgument,
                "the faces have " + std::to_string(corners) + " corners, but " +
                    std::to_string(polygons.corners.count()) + " are given");
  }
  const int vertices = polygons.positions.count();
  Array<uint8_t> isUsed(polygons.positions.size(), 0);
  const int* corner = polygons.corners.data();
  for (int face = 0; face < polygons.cornerCount.count(); ++face) {
    for (int k = 0; k < polygons.cornerCount[face]; ++k, ++corner) {
      if (*corner < 0 || *corner >= vertices) {
        throw Error(ErrorCode::kBadIndex, "face " + std::to_string(face) + " uses vertex " +
                                              std::to_string(*corner) + ", but the mesh has " +
                                              std::to_string(vertices));
      }
      isUsed[*corner] = 1;
    }
  }
  Array<int> used;
  for (int v = 0; v < vertices; ++v) {
    if (isUsed[v]) used.push_back(v);
  }
  if (!used.empty()) checkPositions(polygons.positions, &used);
}

}  // namespace

const char* repairName(Repair::Kind kind) { return wordsOf(kind).name; }

Repair repairOf(Repair::Kind kind, int count) {
  const Words& words = wordsOf(kind);
  return {kind, count, std::to_string(count) + " " + (count == 1 ? words.one : words.many)};
}

ImportedMesh importMesh(TriangleSoup soup, const ImportOptions& options) {
  ImportedMesh result = repairMesh(std::move(soup), options);
  const auto isNone = [](const Repair& repair) { return repair.count == 0; };
  result.repairs.erase(std::remove_if(result.repairs.begin(), result.repairs.end(), isNone),
                       result.repairs.end());
  return result;
}

ImportedMesh importPolygons(PolygonSoup polygons, const ImportOptions& options) {
  checkFaces(polygons);
  CutPolygons cut = cutPolygons(std::move(polygons), options.repair, [](PolygonNumber number) {
    return "face " + std::to_string(number.face);
  });
  ImportedMesh result = importMesh(std::move(cut.soup), options);
  addRepairs({cut.polygonsCut, cut.repeatedCorners, cut.leftOut,
              "face " + std::to_string(cut.firstLeftOut.face)},
             result.repairs);
  return result;
}

ImportedMesh importObj(ObjContents contents, const ImportOptions& options) {
  ImportedMesh result = importMesh(std::move(contents.soup), options);
  addRepairs({contents.polygonsCut, contents.repeatedCorners, contents.leftOut,
              "line " + std::to_string(contents.firstLineLeftOut)},
             result.repairs);
  return result;
}

ImportedMesh importObj(std::string_view bytes, const ImportOptions& options) {
  return importObj(readObj(bytes, {options.repair, {}}), options);
}

}  // namespace karcher

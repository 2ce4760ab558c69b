#include "mesh/mesh_import.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/mesh_repair.h"
#include "mesh/obj_reader.h"

namespace karcher {
namespace {

struct Words {
  const char* name;
  const char* one;   ///< behind "1"
  const char* many;  ///< behind another number
};

/// By their kind.
constexpr std::array<Words, 11> kWords = {{
    {"triangulated", "polygon was cut into triangles", "polygons were cut into triangles"},
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
     "parted from them",
     "edges had more than two faces: the two of the widest angle stayed together, the others were "
     "parted from them"},
    {"bowTie", "vertex between several fans of faces became one for each",
     "vertices between several fans of faces became one for each"},
    {"dropped", "vertex that no face uses was left out",
     "vertices that no face uses were left out"},
}};

const Words& wordsOf(Repair::Kind kind) { return kWords[static_cast<size_t>(kind)]; }

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

ImportedMesh importObj(std::string_view bytes, const ImportOptions& options) {
  ObjContents contents = readObj(bytes, options.repair);
  ImportedMesh result = importMesh(std::move(contents.soup), options);
  const auto add = [&](Repair::Kind kind, int count) {
    if (count == 0) return;
    auto place = std::find_if(result.repairs.begin(), result.repairs.end(),
                              [&](const Repair& repair) { return repair.kind >= kind; });
    if (place != result.repairs.end() && place->kind == kind) {
      *place = repairOf(kind, place->count + count);
    } else {
      result.repairs.insert(place, repairOf(kind, count));
    }
  };
  add(Repair::Kind::kTriangulated, contents.polygonsCut);
  add(Repair::Kind::kRepeatedCorner, contents.repeatedCorners);
  return result;
}

}  // namespace karcher

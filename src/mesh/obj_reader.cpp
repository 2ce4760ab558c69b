#include "mesh/obj_reader.h"

#include <string>
#include <utility>

#include "mesh/decimal.h"
#include "mesh/error.h"
#include "mesh/obj_lines.h"
#include "mesh/polygon.h"
#include "mesh/positions.h"

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace karcher {
namespace {

[[noreturn]] void throwUncut(int line, int corners) {
  const std::string face =
      "line " + std::to_string(line) + ": the face with " + std::to_string(corners) + " corners ";
  if (corners > kMostPolygonCorners) {
    throw Error(ErrorCode::kDegenerateFace,
                face + "is too large: at most " + std::to_string(kMostPolygonCorners) + " are cut");
  }
  throw Error(ErrorCode::kDegenerateFace,
              face + "cannot be cut into triangles: it crosses itself or has no area");
}

/// The faces as the file has them, in flat arrays.
struct Faces {
  Array<Vec3> positions;
  Array<int> corners;
  Array<int> cornerCount;  ///< per face
};

/// Reads lines that were checked. Corners are read by tinyobjloader's own function rather than by
/// its reader of streams: streams would add a sixth to the module that pages load. Its numbers are
/// not used: most of their decimals are off in the last place, so that vertices at one place,
/// written in two ways, would not be welded.
Faces parse(std::string_view text, const ObjLines& lines) {
  Faces faces;
  faces.positions.reserve(static_cast<size_t>(lines.vertices));
  faces.corners.reserve(3 * static_cast<size_t>(lines.faces));
  faces.cornerCount.reserve(static_cast<size_t>(lines.faces));
  std::string terminated;
  while (!text.empty()) {
    std::string_view line = takeObjLine(text);
    const std::string_view keyword = takeObjWord(line);
    if (keyword == "v") {
      Vec3 position;
      for (double& coordinate : position) coordinate = nearestDouble(takeObjWord(line));
      faces.positions.push_back(position);
    } else if (keyword == "f") {
      int corners = 0;
      for (std::string_view word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
        terminated = word;
        const char* corner = terminated.c_str();
        const int v = tinyobj::parseRawTriple(&corner).v_idx;
        faces.corners.push_back(v > 0 ? v - 1 : faces.positions.count() + v);
        ++corners;
      }
      faces.cornerCount.push_back(corners);
    }
  }
  return faces;
}

/// tinyobjloader's own cutting of polygons is not used: where they are not convex it loses
/// triangles or turns some over.
Array<Triangle> cutFaces(const Faces& faces, const ObjLines& lines) {
  Array<Triangle> triangles;
  triangles.reserve(faces.cornerCount.size());
  Array<Vec3> polygon;
  int polygons = 0;
  const int* corner = faces.corners.data();
  for (const int count : faces.cornerCount) {
    if (count == 3) {
      triangles.emplace_back(corner[0], corner[1], corner[2]);
    } else {
      polygon.clear();
      for (int k = 0; k < count; ++k) polygon.push_back(faces.positions[corner[k]]);
      const Array<Triangle> cut = cutPolygon(polygon);
      if (cut.empty()) throwUncut(lines.polygonLines[polygons], count);
      for (const Triangle& t : cut) {
        triangles.emplace_back(corner[t[0]], corner[t[1]], corner[t[2]]);
      }
      ++polygons;
    }
    corner += count;
  }
  return triangles;
}

}  // namespace

ObjContents readObj(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) {
    throw Error(ErrorCode::kBadFile, "the file is not text: an OBJ file has no zero bytes");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const ObjLines lines = checkObjLines(bytes);
  Faces faces = parse(bytes, lines);
  checkPositions(faces.positions);
  ObjContents contents;
  contents.soup.triangles = cutFaces(faces, lines);
  contents.soup.positions = std::move(faces.positions);
  contents.polygonsCut = lines.polygonLines.count();
  return contents;
}

}  // namespace karcher

#include "mesh/obj_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "mesh/obj_lines.h"
#include "mesh/polygon.h"
#include "mesh/positions.h"
#include "mesh/triangle_mesh.h"

// Under another name: a program that links this library may have a tinyobjloader of its own.
#define tinyobj karcherTinyobj
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

/// The line in one piece, and ended by a zero, as tinyobjloader wants it: line ends are in it where
/// a backslash continues it.
void terminate(std::string_view line, std::string& result) {
  result = line;
  for (size_t i = 0; i < result.size(); ++i) {
    if (result[i] != '\n' && result[i] != '\r') continue;
    result[i] = ' ';
    if (result[i - 1] == '\\') result[i - 1] = ' ';
  }
}

/// Reads lines that were checked. Their numbers are read by tinyobjloader's own functions: its
/// reader of streams would take them apart once more.
Faces parse(std::string_view text, const ObjLines& lines) {
  Faces faces;
  faces.positions.reserve(static_cast<size_t>(lines.vertices));
  faces.corners.reserve(3 * static_cast<size_t>(lines.faces));
  faces.cornerCount.reserve(static_cast<size_t>(lines.faces));
  std::string terminated;
  while (!text.empty()) {
    std::string_view line = takeObjLine(text);
    const std::string_view keyword = takeObjWord(line);
    if (keyword != "v" && keyword != "f") continue;
    terminate(line, terminated);
    const char* token = terminated.c_str();
    if (keyword == "v") {
      Vec3& position = faces.positions.emplace_back();
      tinyobj::parseReal3(&position[0], &position[1], &position[2], &token);
    } else {
      int corners = 0;
      for (token += std::strspn(token, " \t"); *token != 0; token += std::strspn(token, " \t")) {
        const int v = tinyobj::parseRawTriple(&token).v_idx;
        faces.corners.push_back(v > 0 ? v - 1 : faces.positions.count() + v);
        ++corners;
      }
      faces.cornerCount.push_back(corners);
    }
  }
  for (const NotFinite& bad : lines.notFinite) {
    faces.positions[bad.vertex].setConstant(std::nan(""));
  }
  return faces;
}

/// Leaves one of each vertex that a polygon names several times in a row, but three corners at
/// least. Returns whether there was one.
bool takeOnce(Array<int>& corners) {
  Array<int> ring;
  for (const int v : corners) {
    if (ring.empty() || ring.back() != v) ring.push_back(v);
  }
  while (ring.count() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() == corners.size()) return false;
  while (ring.count() < 3) ring.push_back(int(ring.back()));
  corners = std::move(ring);
  return true;
}

/// A fan of triangles, each without area, where all corners lie on a line.
Array<Triangle> fanOnALine(const Array<Vec3>& corners) {
  if (corners.count() > kMostPolygonCorners) return {};
  Array<Triangle> fan;
  for (int k = 2; k < corners.count(); ++k) {
    if (!isDegenerate(corners[0], corners[k - 1], corners[k])) return {};
    fan.emplace_back(0, k - 1, k);
  }
  return fan;
}

/// tinyobjloader's own cutting of polygons is not used: where they are not convex it loses
/// triangles or turns some over.
void cutFaces(const Faces& faces, const ObjLines& lines, bool mend, ObjContents& contents) {
  Array<Triangle>& triangles = contents.soup.triangles;
  triangles.reserve(faces.cornerCount.size());
  Array<Vec3> polygon;
  Array<int> ring;
  int polygons = 0;
  const int* corner = faces.corners.data();
  for (const int count : faces.cornerCount) {
    if (count == 3) {
      triangles.emplace_back(corner[0], corner[1], corner[2]);
      corner += count;
      continue;
    }
    ring.assign(corner, corner + count);
    corner += count;
    const int line = lines.polygonLines[polygons++];
    if (mend && takeOnce(ring)) {
      // The importer counts a face that has lost all but two corners.
      contents.repeatedCorners += ring[1] != ring[2] ? 1 : 0;
      if (ring.count() == 3) {
        triangles.emplace_back(ring[0], ring[1], ring[2]);
        continue;
      }
    }
    polygon.clear();
    for (const int v : ring) polygon.push_back(faces.positions[v]);
    Array<Triangle> cut = cutPolygon(polygon);
    if (cut.empty() && mend) cut = fanOnALine(polygon);
    if (cut.empty()) throwUncut(line, count);
    for (const Triangle& t : cut) triangles.emplace_back(ring[t[0]], ring[t[1]], ring[t[2]]);
    ++contents.polygonsCut;
  }
}

/// That no face uses a vertex that is not finite.
void checkUses(const Faces& faces, const ObjLines& lines) {
  if (lines.notFinite.empty()) return;
  Array<uint8_t> used(faces.positions.size(), 0);
  for (const int v : faces.corners) used[v] = 1;
  for (const NotFinite& bad : lines.notFinite) {
    if (used[bad.vertex]) throw Error(ErrorCode::kNotFinite, bad.sentence);
  }
}

}  // namespace

ObjContents readObj(std::string_view bytes, bool mend) {
  if (bytes.find('\0') != std::string_view::npos) {
    throw Error(ErrorCode::kBadFile, "the file is not text: an OBJ file has no zero bytes");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const ObjLines lines = checkObjLines(bytes);
  if (!mend && !lines.notFinite.empty()) {
    throw Error(ErrorCode::kNotFinite, lines.notFinite[0].sentence);
  }
  Faces faces = parse(bytes, lines);
  checkUses(faces, lines);
  if (lines.notFinite.empty()) checkPositions(faces.positions);
  ObjContents contents;
  cutFaces(faces, lines, mend, contents);
  contents.soup.positions = std::move(faces.positions);
  return contents;
}

}  // namespace karcher

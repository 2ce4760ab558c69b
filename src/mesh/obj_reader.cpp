#include "mesh/obj_reader.h"

#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "mesh/obj_lines.h"
#include "mesh/polygon_soup.h"
#include "mesh/positions.h"

// Under another name: a program that links this library may have a tinyobjloader of its own.
#define tinyobj karcherTinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace karcher {
namespace {

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
PolygonSoup parse(std::string_view text, const ObjLines& lines) {
  PolygonSoup faces;
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
      const size_t before = faces.corners.size();
      int corners = 0;
      for (token += std::strspn(token, " \t"); *token != 0; token += std::strspn(token, " \t")) {
        const int v = tinyobj::parseRawTriple(&token).v_idx;
        faces.corners.push_back(v > 0 ? v - 1 : faces.positions.count() + v);
        ++corners;
      }
      // A point or a line, which the check has counted.
      if (corners < 3) {
        faces.corners.resize(before);
      } else {
        faces.cornerCount.push_back(corners);
      }
    }
  }
  for (const NotFinite& bad : lines.notFinite) {
    faces.positions[bad.vertex].setConstant(std::nan(""));
  }
  return faces;
}

/// That no face uses a vertex that is not finite.
void checkUses(const PolygonSoup& faces, const ObjLines& lines) {
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
  if (!mend && !lines.shortLines.empty()) {
    throw Error(ErrorCode::kBadFile, shortFace(lines.shortLines[0]));
  }
  PolygonSoup faces = parse(bytes, lines);
  checkUses(faces, lines);
  if (lines.notFinite.empty()) checkPositions(faces.positions);
  const auto lineOf = [&](PolygonNumber number) { return lines.polygonLines[number.polygon]; };
  CutPolygons cut = cutPolygons(std::move(faces), mend, [&](PolygonNumber number) {
    return "line " + std::to_string(lineOf(number));
  });
  ObjContents contents;
  contents.soup = std::move(cut.soup);
  contents.polygonsCut = cut.polygonsCut;
  contents.repeatedCorners = cut.repeatedCorners;
  contents.leftOut = cut.leftOut + lines.shortLines.count();
  if (cut.leftOut > 0) contents.firstLineLeftOut = lineOf(cut.firstLeftOut);
  if (!lines.shortLines.empty() &&
      (cut.leftOut == 0 || lines.shortLines[0] < contents.firstLineLeftOut)) {
    contents.firstLineLeftOut = lines.shortLines[0];
  }
  return contents;
}

}  // namespace karcher

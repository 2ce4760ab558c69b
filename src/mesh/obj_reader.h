#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/triangle_soup.h"

/// Reading of Wavefront OBJ files: vertex positions, faces, parts, materials and colors. Normals,
/// texture coordinates, lines and points are ignored.
namespace karcher {

/// An object or group, which a line `o` or `g` begins. A repeated name continues its part.
struct ObjPart {
  std::string name;   ///< "object, group"; "mesh" for faces before any such line
  int triangles = 0;  ///< a polygon counts as the triangles it is cut into
};

/// The parts, materials and colors of an OBJ file.
struct ObjMarks {
  Array<ObjPart> parts;          ///< all of the file, in the order of their first faces
  Array<int> part;               ///< per triangle; empty if the file has only one
  Array<std::string> materials;  ///< names, in the order of their first faces
  Array<int> material;           ///< per triangle, -1 for none; empty where the file has none
  /// Red, green and blue of each vertex, white if its line has none; empty if no line has them. In
  /// the file they range to 1, or to 255 if any is greater than 1.
  Array<uint8_t> colors;
};

struct ObjContents {
  /// Vertices in the file's order, numbered from 0; triangles in the file's order, those of a
  /// polygon one after another.
  TriangleSoup soup;
  ObjMarks marks;
  int polygonsCut = 0;  ///< faces with more than three corners
  int repeatedCorners =
      0;            ///< of them, those that named a vertex twice in a row; it was taken once
  int leftOut = 0;  ///< faces of fewer than three corners, or that cannot be cut
  int firstLineLeftOut = 0;  ///< the line of the first of them, from 1
};

struct ObjOptions {
  /// Accepts non-finite coordinates of vertices that no face uses, leaves out faces of fewer than
  /// three corners, and mends polygons as `cutPolygons` does.
  bool mend = true;
  /// The parts whose faces are read; if unset, all are.
  std::optional<Array<int>> parts;
};

/// `bytes` is the content of the file, with any line ends. Every line is checked before
/// tinyobjloader reads the file, since that reads whatever it does not understand as 0. Numbers are
/// read to within 10 units in the last place. Throws Error with the number of the line, from 1:
/// kBadFile (not text, no faces, a vertex or face that cannot be read), kNotFinite (a coordinate
/// nan or inf), kBadIndex (a face uses a vertex that the file does not have), kDegenerateFace (a
/// polygon that cannot be cut into triangles); and kBadArgument for a part that does not exist.
ObjContents readObj(std::string_view bytes, const ObjOptions& options = {});

}  // namespace karcher

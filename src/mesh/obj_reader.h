#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/triangle_soup.h"

/// A reader of Wavefront OBJ files: vertex positions, faces, parts, materials and colors. It
/// ignores normals and texture coordinates, and counts lines and other elements.
namespace karcher {

/// An object or group, which begins at a line `o` or `g`. A repeated name continues its part.
struct ObjPart {
  std::string name;   ///< "object, group"; "mesh" for faces before any such line
  int triangles = 0;  ///< the number of triangles; a polygon counts as its triangles
};

/// The parts, materials and colors of an OBJ file.
struct ObjMarks {
  Array<ObjPart> parts;          ///< all parts of the file, in the order of their first faces
  Array<int> part;               ///< the part of each triangle; empty if the file has one part
  Array<std::string> materials;  ///< names, in the order of their first faces
  Array<int> material;  ///< the material of each triangle, -1 for none; empty without materials
  /// Red, green and blue of each vertex, from 0 to 255; white for a vertex without a color; empty
  /// if no vertex has a color. In the file, values range up to 1, or up to 255 if any value is
  /// greater than 1.
  Array<uint8_t> colors;
  int otherElements = 0;  ///< the number of points, lines, curves and surfaces
};

struct ObjContents {
  /// Vertices in the file's order, numbered from 0, and triangles in the file's order. The
  /// triangles of a polygon are consecutive.
  TriangleSoup soup;
  ObjMarks marks;
  int polygonsCut = 0;  ///< the number of polygons cut into triangles
  /// the number of polygons that named a vertex twice in a row and lost the repetition
  int repeatedCorners = 0;
  int leftOut = 0;  ///< the number of faces that have fewer than three corners or cannot be cut
  int firstLineLeftOut = 0;  ///< the line of the first of these faces, from 1
};

struct ObjOptions {
  /// Whether to mend the file. If so, vertices that no face uses may have any coordinates,
  /// the reader omits faces of fewer than three corners, and `cutPolygons` mends polygons.
  bool mend = true;
  /// The parts whose faces to read; all parts if unset.
  std::optional<Array<int>> parts;
};

/// `bytes` is the content of the file, with any line ends. The function checks every line before
/// tinyobjloader reads it, since tinyobjloader replaces a number that it does not understand by 0.
/// Numbers are right to within 10 units in the last place. Throws Error with the number of the
/// line, from 1: kBadFile (not text, no faces, a vertex or face that cannot be read), kNotFinite (a
/// coordinate nan or inf), kBadIndex (a face uses a vertex that the file does not have),
/// kDegenerateFace (a polygon that cannot be cut into triangles); kBadArgument (a part does not
/// exist).
ObjContents readObj(std::string_view bytes, const ObjOptions& options = {});

}  // namespace karcher

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/triangle_soup.h"

/// Reading Wavefront OBJ: vertex positions and faces, and what the file says of them beside the
/// surface. Normals, texture coordinates, lines and points are ignored.
namespace karcher {

/// An object or group, as the lines `o` and `g` begin them. A name that comes again goes on with
/// its part.
struct ObjPart {
  std::string name;   ///< "object, group"; "mesh" of faces before any such line
  int triangles = 0;  ///< of polygons, as many as they are cut into
};

/// What an OBJ file says of its vertices and triangles beside the surface.
struct ObjMarks {
  Array<ObjPart> parts;          ///< all of the file, in the order of their first faces
  Array<int> part;               ///< per triangle; empty where the file has one
  Array<std::string> materials;  ///< names, in the order of their first faces
  Array<int> material;           ///< per triangle, -1 for none; empty where the file has none
  /// Red, green and blue of each vertex, white where its line has none; empty where none has. In
  /// the file they are numbers to 1, or to 255 where one is greater than 1.
  Array<uint8_t> colors;
};

struct ObjContents {
  /// Vertices in the file's order, numbered from 0; triangles in the file's order, those of a
  /// polygon one after another.
  TriangleSoup soup;
  ObjMarks marks;
  int polygonsCut = 0;       ///< faces with more than three corners
  int repeatedCorners = 0;   ///< of those that named a vertex twice in a row; it was taken once
  int leftOut = 0;           ///< faces of fewer than three corners, or that cannot be cut
  int firstLineLeftOut = 0;  ///< the line of the first of them, from 1
};

struct ObjOptions {
  /// Lets a coordinate through that is not finite where no face uses its vertex, leaves out faces
  /// of fewer than three corners, and mends polygons as `cutPolygons` does.
  bool mend = true;
  /// The parts whose faces are read; all without.
  std::optional<Array<int>> parts;
};

/// `bytes` is the content of the file, with any line ends. Every line is checked first: then
/// tinyobjloader reads the file, which takes what it does not understand for 0. Numbers come within
/// 10 units in the last place of the decimal number. Throws Error with the number of the line, from
/// 1: kBadFile (not text, no faces, a vertex or face that cannot be read), kNotFinite (a coordinate
/// nan or inf), kBadIndex (a face uses a vertex that the file does not have), kDegenerateFace (a
/// polygon that cannot be cut into triangles); and kBadArgument for a part that is not there.
ObjContents readObj(std::string_view bytes, const ObjOptions& options = {});

}  // namespace karcher

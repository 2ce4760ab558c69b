#pragma once

#include <string_view>

#include "mesh/triangle_soup.h"

/// Reading Wavefront OBJ: vertex positions and faces. Normals, texture coordinates, groups,
/// materials, lines and points are ignored.
namespace karcher {

struct ObjContents {
  /// Vertices in the file's order, numbered from 0; triangles in the file's order, those of a
  /// polygon one after another.
  TriangleSoup soup;
  int polygonsCut = 0;       ///< faces with more than three corners
  int repeatedCorners = 0;   ///< of those that named a vertex twice in a row; it was taken once
  int leftOut = 0;           ///< faces of fewer than three corners, or that cannot be cut
  int firstLineLeftOut = 0;  ///< the line of the first of them, from 1
};

/// `bytes` is the content of the file, with any line ends. Every line is checked first: then
/// tinyobjloader's functions read its numbers, which take what they do not understand for 0. They
/// come within 10 units in the last place of the decimal number. With `mend` a coordinate that is
/// not finite is let through where no face uses its vertex, faces of fewer than three corners are
/// left out, and polygons are mended as `cutPolygons` does. Throws Error with the number of the
/// line, from 1: kBadFile (not text, no faces, a vertex or face that cannot be read), kNotFinite (a
/// coordinate nan or inf), kBadIndex (a face uses a vertex that the file does not have),
/// kDegenerateFace (a polygon that cannot be cut into triangles).
ObjContents readObj(std::string_view bytes, bool mend = true);

}  // namespace karcher

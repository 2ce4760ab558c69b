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
  int polygonsCut = 0;  ///< faces with more than three corners
};

/// `bytes` is the content of the file, with any line ends. Every line is checked first. Then each
/// coordinate becomes the double nearest to its decimal number (decimal.h), and tinyobjloader reads
/// the corners of faces: it takes what it does not understand for 0.
/// Throws Error with the number of the line, from 1: kBadFile (not text, no faces, a vertex or face
/// that cannot be read), kNotFinite (a coordinate nan or inf), kBadIndex (a face uses a vertex
/// that the file does not have), kDegenerateFace (a polygon that cannot be cut into triangles).
ObjContents readObj(std::string_view bytes);

}  // namespace karcher

#pragma once

#include <functional>
#include <string>

#include "mesh/triangle_soup.h"

namespace karcher {

/// Unchecked polygons of a file or a caller, in flat arrays.
struct PolygonSoup {
  Array<Vec3> positions;
  Array<int> corners;
  Array<int> cornerCount;  ///< the number of corners of each face, at least 3
  Array<int> mark;         ///< a number for each face, which its triangles inherit; may be empty
};

/// The number of a face among all faces, and among the faces with more than three corners.
struct PolygonNumber {
  int face = -1;
  int polygon = -1;
};

struct CutPolygons {
  /// The unchanged vertices, and the triangles in the order of the faces. The triangles of a
  /// polygon are consecutive.
  TriangleSoup soup;
  Array<int> mark;      ///< the mark of each triangle's face; empty without marks
  int polygonsCut = 0;  ///< the number of polygons cut into triangles
  /// the number of polygons that named a vertex twice in a row and lost the repetition
  int repeatedCorners = 0;
  int leftOut = 0;  ///< the number of faces that cannot be cut
  PolygonNumber firstLeftOut;
};

/// Cuts polygons into triangles; their corners must be existing vertices with finite positions.
///
/// With `mend`, a vertex that a polygon names twice in a row counts once. A polygon whose corners
/// all lie on a line becomes a fan of triangles without area. The shorter diagonal cuts a quad that
/// crosses itself. Other polygons that cannot be cut are omitted.
///
/// Without `mend`, or if no face would remain, throws Error kDegenerateFace for the first polygon
/// that cannot be cut, and names this polygon by `placeOf`, for example "line 12".
CutPolygons cutPolygons(PolygonSoup polygons, bool mend,
                        const std::function<std::string(PolygonNumber)>& placeOf);

}  // namespace karcher

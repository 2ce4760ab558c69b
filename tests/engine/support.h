#pragma once

#include <functional>

#include "intrinsic/geometry.h"
#include "mesh/error.h"
#include "mesh/triangle_soup.h"

/// What several tests share.
namespace karcher {

/// Unit squares from (0, 0) to (columns, rows) in the plane z = 0, each cut from its lower left to
/// its upper right corner. Vertex i + (columns + 1) j lies at (i, j).
TriangleMesh planeGrid(int columns, int rows);

TriangleMesh meshOf(const TriangleSoup& soup);

/// A vector in space, at a vertex of a flat mesh, in the vertex's frame.
Vec2 inVertexFrame(const Geometry& geometry, int vertex, const Vec3& vector);

/// The mesh of the npm package `bunny`, vertices and faces in its own order. Throws
/// std::runtime_error if the set-up has not written it.
TriangleMesh bunnyMesh();

/// Whether the tests are to draw the large numbers of cases: with KARCHER_LONG=1 in the
/// environment, as `npm run check:long` sets it.
bool longRun();

/// The code of the Error that the action throws; a failure of the test if it throws none.
ErrorCode codeOf(const std::function<void()>& action);

}  // namespace karcher

#pragma once

#include <fstream>
#include <functional>
#include <string>

#include "intrinsic/geometry.h"
#include "mesh/error.h"
#include "mesh/triangle_soup.h"

/// Helpers that several tests share.
namespace karcher {

/// Unit squares from (0, 0) to (columns, rows) in the plane z = 0, each cut from its lower left to
/// its upper right corner. Vertex i + (columns + 1) j lies at (i, j).
TriangleMesh planeGrid(int columns, int rows);

/// Two of planeGrid(3, 3) side by side, the second 10 to the right: points of both are unreachable
/// from each other.
TriangleMesh twoGrids();

/// An L of unit squares: of those from (0, 0) to (12, 12), the ones left of x = 4 or below y = 4.
/// The boundary has a corner at (4, 4) that points inwards.
TriangleMesh gridWithCorner();

TriangleMesh meshOf(const TriangleSoup& soup);

/// A vector in space at a vertex of a flat mesh, converted to the vertex's frame.
Vec2 inVertexFrame(const Geometry& geometry, int vertex, const Vec3& vector);

/// An open file of tests/data. Throws std::runtime_error if it is missing.
std::ifstream testData(const std::string& name);

/// The mesh of the npm package `bunny`, vertices and faces in its own order. Throws
/// std::runtime_error if the set-up has not written it.
TriangleMesh bunnyMesh();

/// Whether to draw the large numbers of cases: with KARCHER_LONG=1 in the environment, as `npm run
/// check:long` sets it.
bool longRun();

/// Whether sanitizers run, which make the tests ten times as slow, and KARCHER_SANITIZED=all is not
/// in the environment, as `npm run check:long` sets it.
bool leavesLongestOut();

/// The first line of the slowest tests, which repeat numerics in many similar cases and always run
/// without the sanitizers.
#define SKIP_WHERE_SANITIZED() \
  if (leavesLongestOut()) GTEST_SKIP() << "in a long run, or without sanitizers"

/// The code of the Error that the action throws; a failure of the test if it throws none.
ErrorCode codeOf(const std::function<void()>& action);

}  // namespace karcher

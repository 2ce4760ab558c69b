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

/// An L of unit squares: those between (0, 0) and (12, 12) that lie left of x = 4 or below y = 4.
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

/// Whether to draw the large numbers of cases: whether the environment has KARCHER_LONG=1, which
/// `npm run check:long` sets.
bool longRun();

/// Whether to leave out the longest tests: sanitizers run, which make the tests ten times as slow,
/// and the environment lacks KARCHER_SANITIZED=all, which `npm run check:long` sets.
bool leavesLongestOut();

/// The first line of the slowest tests, which repeat numerics in many similar cases and always run
/// without the sanitizers.
#define SKIP_WHERE_SANITIZED() \
  if (leavesLongestOut()) GTEST_SKIP() << "in a long run, or without sanitizers"

/// The code of the Error that the action throws. If it throws none, the test fails.
ErrorCode codeOf(const std::function<void()>& action);

}  // namespace karcher

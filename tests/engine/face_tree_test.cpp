#include "mesh/face_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/nearest_in_triangle.h"
#include "mesh/shapes.h"
#include "mesh/triangle_mesh.h"
#include "support.h"

namespace karcher {
namespace {

TEST(FaceTree, AgreesWithASearchOfAllFaces) {
  TriangleSoup soup = makeShape(Shape::kKnot, 700);
  const TriangleMesh mesh = buildMesh(std::move(soup.positions), std::move(soup.triangles));
  const FaceTree tree(mesh);
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 300; ++i) {
    const Vec3 place(coordinate(random), coordinate(random), coordinate(random));
    double least = kInfinity;
    for (int face = 0; face < mesh.faceCount(); ++face) {
      const auto corner = [&](int k) { return mesh.positions[mesh.corner(face, k)]; };
      const Vec3 bary = nearestInTriangle(place, corner(0), corner(1), corner(2));
      const Vec3 at = bary[0] * corner(0) + bary[1] * corner(1) + bary[2] * corner(2);
      least = std::min(least, (at - place).norm());
    }
    EXPECT_EQ(tree.nearest(place).distance, least) << "seed " << kSeed << ", place " << i;
  }
}

/// A fan whose apex is the point nearest to each place. The box of the later four faces is nearer.
TEST(FaceTree, TakesTheSmallestOfEquallyNearFaces) {
  const Array<Vec3> positions = {{0, 0, 0},      {2, 0, 0},      {1, 1, 0},    {0, 2, 0},
                                 {0, 1, 1},      {0, 0, 2},      {-.25, 0, 2}, {-.5, 0, 2},
                                 {-.5, -.25, 2}, {-.25, -.25, 2}};
  Array<Triangle> triangles;
  for (int i = 1; i < 9; ++i) triangles.emplace_back(0, i, i + 1);
  const TriangleMesh mesh = buildMesh(positions, triangles);
  const FaceTree tree(mesh);
  for (int i = 1; i <= 100; ++i) {
    EXPECT_EQ(tree.nearest(Vec3::Constant(-i)).face, 0) << "place -" << i;
  }
}

TEST(FaceTree, RefusesPlacesWhoseSquaresOverflow) {
  TriangleSoup soup = makeShape(Shape::kKnot, 700);
  const TriangleMesh mesh = buildMesh(std::move(soup.positions), std::move(soup.triangles));
  const FaceTree tree(mesh);
  EXPECT_LT(tree.nearest(Vec3::Constant(1e30)).distance, 1e31);
  for (const double far : {1e31, 1e160, -1e308}) {
    EXPECT_EQ(codeOf([&] { tree.nearest(Vec3::Constant(far)); }), ErrorCode::kBadArgument);
  }
  EXPECT_EQ(codeOf([&] { tree.nearest(Vec3::Constant(kInfinity)); }), ErrorCode::kNotFinite);
}

}  // namespace
}  // namespace karcher

#include "mesh/shapes.h"

#include <string>

#include "mesh/error.h"
#include "mesh/genus_three.h"
#include "mesh/split_triangles.h"
#include "mesh/staggered_grid.h"

namespace karcher {
namespace {

const double kTorusRoot = std::sqrt(kTorusMajor * kTorusMajor - kTorusMinor * kTorusMinor);

double torusTubeAngle(double y) {
  const double half = y * kTorusRoot / kTorusMinor / 2;
  return 2 * std::atan2(std::sqrt(kTorusMajor + kTorusMinor) * std::sin(half),
                        std::sqrt(kTorusMajor - kTorusMinor) * std::cos(half));
}

int rounded(double x) { return static_cast<int>(std::lround(x)); }

TriangleSoup torus(int triangles) {
  const GridSize size = staggeredGridSize(2 * kPi, kTorusPeriod, triangles);
  return closedGrid(size, [&](double u, double v) {
    return conformalTorus(Vec2(2 * kPi * u, kTorusPeriod * v));
  });
}

/// The trefoil knot, about 1 in size, at parameter t in [0, 2 pi].
Vec3 trefoil(double t) {
  return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
              -std::sin(3 * t)) /
         3;
}

/// Points at equal distances along a closed curve, a function on [0, 2 pi].
template <class Curve>
Array<Vec3> evenPoints(int count, Curve&& curve) {
  constexpr int kSteps = 20'000;
  Array<Vec3> fine;
  Array<double> length = {0};
  for (int i = 0; i <= kSteps; ++i) {
    fine.push_back(curve(2 * kPi * i / kSteps));
    if (i > 0) length.push_back(length[i - 1] + (fine[i] - fine[i - 1]).norm());
  }
  Array<Vec3> result;
  int i = 0;
  for (int k = 0; k < count; ++k) {
    const double target = length.back() * k / count;
    while (length[i + 1] < target) ++i;
    const double s = (target - length[i]) / (length[i + 1] - length[i]);
    result.push_back(curve(2 * kPi * (i + s) / kSteps));
  }
  return result;
}

/// Unit normals along a closed curve that turn as little as possible. Two reflections move each
/// normal to the next point (W. Wang, B. Juettler, D. Zheng, Y. Liu, "Computation of Rotation
/// Minimizing Frames", 2008); the angle that is missing at the end is spread over all normals.
Array<Vec3> minimalNormals(const Array<Vec3>& points, const Array<Vec3>& tangents) {
  const int n = points.count();
  Array<Vec3> normals = {tangents[0].unitOrthogonal()};
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const auto reflected = [](const Vec3& v, const Vec3& mirror) {
      return Vec3(v - 2 * mirror.dot(v) / mirror.squaredNorm() * mirror);
    };
    const Vec3 chord = points[j] - points[i];
    const Vec3 turn = tangents[j] - reflected(tangents[i], chord);
    normals.push_back(reflected(reflected(normals[i], chord), turn));
  }
  const Vec3 closed = normals.back();
  normals.pop_back();
  const double missing =
      std::atan2(closed.cross(normals[0]).dot(tangents[0]), closed.dot(normals[0]));
  for (int i = 0; i < n; ++i) {
    normals[i] = Eigen::AngleAxisd(missing * i / n, tangents[i]) * normals[i];
  }
  return normals;
}

TriangleSoup knot(int triangles) {
  constexpr double kRadius = 0.15;
  constexpr double kLength = 9.61;  // the length of the trefoil
  const GridSize size = staggeredGridSize(kLength, 2 * kPi * kRadius, triangles);
  const Array<Vec3> points = evenPoints(size.rows, trefoil);
  Array<Vec3> tangents;
  for (int i = 0; i < size.rows; ++i) {
    const Vec3 chord = points[(i + 1) % size.rows] - points[(i + size.rows - 1) % size.rows];
    tangents.push_back(chord.normalized());
  }
  const Array<Vec3> normals = minimalNormals(points, tangents);
  return closedGrid(size, [&](double u, double v) {
    const int i = rounded(u * size.rows);
    const Vec2 direction = kRadius * unitVector(2 * kPi * v);
    return Vec3(points[i] + direction.x() * normals[i] +
                direction.y() * normals[i].cross(tangents[i]));
  });
}

TriangleSoup openSheet(int triangles) {
  constexpr double kWidth = 2;
  constexpr double kHeight = 1.4;
  const GridSize size = staggeredGridSize(kHeight, kWidth, triangles);
  return openGrid(size, [&](double u, double v) {
    const double x = kWidth * (v - 0.5);
    const double y = kHeight * (u - 0.5);
    return Vec3(x, y, 0.2 * std::sin(2.4 * x + 0.5) * std::cos(2.8 * y) + 0.12 * x * y);
  });
}

}  // namespace

const double kTorusPeriod = 2 * kPi * kTorusMinor / kTorusRoot;

Vec3 conformalTorus(const Vec2& x) {
  const double angle = torusTubeAngle(x.y());
  const Vec2 u = (kTorusMajor + kTorusMinor * std::cos(angle)) * unitVector(x.x());
  return {u.x(), u.y(), kTorusMinor * std::sin(angle)};
}

const char* shapeName(Shape shape) {
  switch (shape) {
    case Shape::kSphere:
      return "sphere";
    case Shape::kTorus:
      return "torus";
    case Shape::kKnot:
      return "knot";
    case Shape::kGenus3:
      return "genus3";
    case Shape::kOpenSheet:
      return "openSheet";
  }
  return "unknown";
}

TriangleSoup icosphere(int frequency) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Array<Vec3> corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                         {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const Array<Triangle> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Vec3& p : corners) p.normalize();
  TriangleSoup soup = splitTriangles(buildMesh(corners, faces), frequency);
  for (Vec3& p : soup.positions) p.normalize();
  return soup;
}

TriangleSoup makeShape(Shape shape, int triangles) {
  if (triangles < kFewestShapeTriangles || triangles > kMostShapeTriangles) {
    throw Error(ErrorCode::kBadArgument, "a shape has " + std::to_string(kFewestShapeTriangles) +
                                             " to " + std::to_string(kMostShapeTriangles) +
                                             " triangles, not " + std::to_string(triangles));
  }
  switch (shape) {
    case Shape::kSphere:
      return icosphere(rounded(std::sqrt(triangles / 20.0)));
    case Shape::kTorus:
      return torus(triangles);
    case Shape::kKnot:
      return knot(triangles);
    case Shape::kGenus3:
      return genusThree(triangles);
    case Shape::kOpenSheet:
      return openSheet(triangles);
  }
  throw Error(ErrorCode::kBadArgument, "there is no such shape");
}

}  // namespace karcher

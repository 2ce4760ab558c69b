#include "mesh/genus_three.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "mesh/split_triangles.h"

// A slab of cubes without three of them has the right topology. Subdivision of its faces adds
// vertices. The vertices move to the zero set of a smooth function and spread out there. Further
// rounds do the same, each with triangles of half the size.

namespace karcher {
namespace {

constexpr double kRing = 0.5;
constexpr double kTube = 0.22;
/// the distance of the rings' centers; less than 2 kRing, so that they merge
constexpr double kSpacing = 0.95;
constexpr double kBlend = 0.07;  ///< the width of the rounded joints

struct Implicit {
  double value;
  Vec3 gradient;
};

/// A smooth minimum of the distances from three tori.
Implicit threeTori(const Vec3& p) {
  double sum = 0;
  Vec3 gradient = Vec3::Zero();
  for (const int i : {-1, 0, 1}) {
    const Vec2 fromCenter(p.x() - i * kSpacing, p.y());
    const double toCenter = std::max(fromCenter.norm(), 1e-9);
    const Vec2 fromTube(toCenter - kRing, p.z());
    const double toTube = std::max(fromTube.norm(), 1e-9);
    const Vec2 outwards = fromTube.x() / toTube * fromCenter / toCenter;
    const double weight = std::exp(-(toTube - kTube) / kBlend);
    sum += weight;
    gradient += weight * Vec3(outwards.x(), outwards.y(), p.z() / toTube);
  }
  return {-kBlend * std::log(sum), gradient / sum};
}

/// The point after a step of Newton's method along the gradient.
Vec3 nearerToSurface(const Vec3& p) {
  const Implicit f = threeTori(p);
  return p - f.value / std::max(f.gradient.squaredNorm(), 0.1) * f.gradient;
}

/// The surface of a slab of cubes, one for each # of the plan, scaled to the size of the rings.
TriangleMesh slab() {
  const std::array<std::string_view, 3> plan = {"#######",  //
                                                "# # # #",  //
                                                "#######"};
  const int rows = static_cast<int>(plan.size());
  const int columns = static_cast<int>(plan[0].size());
  const auto filled = [&](int i, int j, int k) {
    if (i < 0 || i >= columns || j < 0 || j >= rows || k != 0) return false;
    return plan[static_cast<size_t>(j)][static_cast<size_t>(i)] == '#';
  };
  std::map<std::array<int, 3>, int> numbers;
  Array<Vec3> positions;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, isNew] = numbers.insert({at, positions.count()});
    if (isNew) {
      positions.push_back(kSpacing / 2 * Vec3(at[0] - 3.5, at[1] - 1.5, at[2] - 0.5));
    }
    return entry->second;
  };
  Array<Triangle> faces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (!filled(i, j, 0)) continue;
      for (size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          std::array<int, 3> neighbour = {i, j, 0};
          neighbour[axis] += 2 * side - 1;
          if (filled(neighbour[0], neighbour[1], neighbour[2])) continue;
          const size_t u = (axis + 1) % 3;
          const size_t v = (axis + 2) % 3;
          std::array<int, 3> at = {i, j, 0};
          at[axis] += side;
          const int a = vertex(at);
          ++at[u];
          const int b = vertex(at);
          ++at[v];
          const int c = vertex(at);
          --at[u];
          const int d = vertex(at);
          if (side == 1) {
            faces.emplace_back(a, b, c);
            faces.emplace_back(a, c, d);
          } else {
            faces.emplace_back(a, c, b);
            faces.emplace_back(a, d, c);
          }
        }
      }
    }
  }
  return buildMesh(positions, faces);
}

/// Moves every vertex towards the mean of its neighbours, and back onto the surface.
void spread(TriangleMesh& mesh, int steps) {
  for (int step = 0; step < steps; ++step) {
    Array<Vec3> sum(mesh.positions.size(), Vec3::Zero());
    Array<int> valence(mesh.positions.size(), 0);
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      sum[mesh.tail(h)] += mesh.positions[mesh.head(h)];
      ++valence[mesh.tail(h)];
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      mesh.positions[v] = nearerToSurface((mesh.positions[v] + sum[v] / valence[v]) / 2);
    }
  }
}

TriangleMesh splitMesh(const TriangleMesh& mesh, int parts) {
  TriangleSoup soup = splitTriangles(mesh, parts);
  return buildMesh(std::move(soup.positions), std::move(soup.triangles));
}

}  // namespace

TriangleSoup genusThree(int triangles) {
  const TriangleMesh coarse = slab();
  // Each edge is first cut into 2 to 7 parts. Further rounds halve the parts.
  double parts = std::sqrt(static_cast<double>(triangles) / coarse.faceCount());
  int doublings = 0;
  for (; parts > 7.5; parts /= 2) ++doublings;
  TriangleMesh mesh = splitMesh(coarse, std::max(2, static_cast<int>(std::lround(parts))));
  constexpr int kFirstSteps = 60;
  constexpr int kLaterSteps = 4;
  spread(mesh, kFirstSteps);
  for (int i = 0; i < doublings; ++i) {
    mesh = splitMesh(mesh, 2);
    spread(mesh, kLaterSteps);
  }
  constexpr int kNewtonSteps = 5;
  for (int step = 0; step < kNewtonSteps; ++step) {
    for (Vec3& p : mesh.positions) p = nearerToSurface(p);
  }
  return {std::move(mesh.positions), std::move(mesh.faces)};
}

}  // namespace karcher

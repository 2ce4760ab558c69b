#include "generators/gallery.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <utility>

#include "generators/delaunay.h"
#include "generators/flat.h"
#include "generators/grid.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/rough.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "mesh/shapes.h"

namespace karcher {
namespace {

/// Vertices by place, so that adjacent pieces share them.
class SharedVertices {
 public:
  explicit SharedVertices(TriangleSoup& soup) : soup_(soup) {}

  int at(const Vec3& p) {
    const auto [entry, isNew] =
        numbers_.try_emplace({p.x(), p.y(), p.z()}, soup_.positions.count());
    if (isNew) soup_.positions.push_back(p);
    return entry->second;
  }

 private:
  TriangleSoup& soup_;
  std::map<std::array<double, 3>, int> numbers_;
};

TriangleSoup moved(TriangleSoup soup, const Vec3& scale, const Vec3& shift) {
  for (Vec3& p : soup.positions) p = (p.array() * scale.array()).matrix() + shift;
  return soup;
}

/// A sheet of Delaunay triangles of random points, with random heights of `noise` of an edge.
TriangleSoup roughSheet(int triangles, double noise, uint64_t seed) {
  TriangleSoup soup = tessellatedPlane(PlaneTessellation::kJitteredDelaunay, triangles, seed);
  const double edge = 1.5 / std::sqrt(triangles);
  Random random(seed);
  for (Vec3& p : soup.positions) p.z() = random.uniform(-noise, noise) * edge;
  return soup;
}

TriangleSoup sheared(TriangleSoup soup, double shear) {
  for (Vec3& p : soup.positions) p.x() += shear * p.y();
  return soup;
}

/// The soup with a needle or a cap in every fifth triangle: a vertex `height` of an edge from a
/// corner, or from the middle of a side.
TriangleSoup withSlivers(TriangleSoup soup, double height, bool needles) {
  const int count = soup.triangles.count();
  for (int f = 0; f < count; f += 5) {
    const Triangle t = soup.triangles[f];
    const Vec3 a = soup.positions[t[0]];
    const Vec3 b = soup.positions[t[1]];
    const Vec3 c = soup.positions[t[2]];
    const Vec3 p = needles ? Vec3(a + height * ((b + c) / 2 - a))
                           : Vec3((a + b) / 2 + height * (c - (a + b) / 2));
    const int v = soup.positions.count();
    soup.positions.push_back(p);
    soup.triangles[f] = {t[0], t[1], v};
    soup.triangles.push_back({t[1], t[2], v});
    soup.triangles.push_back({t[2], t[0], v});
  }
  return soup;
}

/// A box of unit squares `n` to the unit, jittered within its sides; edges may be cut back by
/// `bevel`.
TriangleSoup creasedBox(const Vec3& size, int n, double jitter, uint64_t seed) {
  TriangleSoup soup;
  SharedVertices vertices(soup);
  Random random(seed);
  std::map<int, Vec3> offsets;
  const auto number = [&](const Vec3& p) {
    const int before = soup.positions.count();
    const int v = vertices.at(p);
    if (v == before) {
      Vec3 offset;
      for (int k = 0; k < 3; ++k) {
        const bool isInside = p[k] > 0 && p[k] < size[k];
        offset[k] = isInside ? random.uniform(-jitter, jitter) / n : 0;
      }
      offsets[v] = offset;
    }
    return v;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int w = (axis + 2) % 3;
    for (const bool isFar : {false, true}) {
      for (int i = 0; i < static_cast<int>(size[u] * n); ++i) {
        for (int j = 0; j < static_cast<int>(size[w] * n); ++j) {
          const auto corner = [&](int di, int dj) {
            Vec3 p;
            p[axis] = isFar ? size[axis] : 0;
            p[u] = static_cast<double>(i + di) / n;
            p[w] = static_cast<double>(j + dj) / n;
            return number(p);
          };
          const int a = corner(0, 0);
          int b = corner(1, 0);
          const int c = corner(1, 1);
          int d = corner(0, 1);
          if (!isFar) std::swap(b, d);
          if (random.uniform() < 0.5) {
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
          } else {
            soup.triangles.push_back({a, b, d});
            soup.triangles.push_back({b, c, d});
          }
        }
      }
    }
  }
  for (const auto& [v, offset] : offsets) soup.positions[v] += offset;
  return soup;
}

std::string decimal(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

void addFlat(Array<GalleryMesh>& meshes) {
  for (const int q : {1, 2, 3, 5, 8, 12, 16}) {
    for (const double jitter : {0.0, 0.4}) {
      meshes.push_back({"fans, q = " + std::to_string(q) + (jitter > 0 ? ", jittered" : ""),
                        fanSquares(q < 5 ? 10 : 6, q, jitter, 3), true});
    }
  }
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    meshes.push_back({std::string("plane, ") + tessellationName(tessellation),
                      tessellatedPlane(tessellation, 3000, 5), true});
  }
  meshes.push_back({"plane, stretched 100:1",
                    moved(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 3000, 5),
                          Vec3(100, 1, 1), Vec3::Zero()),
                    true});
  meshes.push_back({"plane, stretched 1000:1",
                    moved(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 3000, 5),
                          Vec3(1000, 1, 1), Vec3::Zero()),
                    true});
  for (const int valence : {100, 1000, 10'000}) {
    meshes.push_back({"disk, valence " + std::to_string(valence),
                      wheel(valence, valence > 5000 ? 0 : 2, 0), true});
  }
  meshes.push_back({"wide grid, 1 to 1e3", wideGrid(6, 6), true});
  for (const double height : {1e-2, 1e-6, 1e-10}) {
    for (const bool needles : {true, false}) {
      meshes.push_back({std::string("plane, ") + (needles ? "needles " : "caps ") + decimal(height),
                        withSlivers(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 1500, 7),
                                    height, needles),
                        true});
    }
  }
}

void addThin(Array<GalleryMesh>& meshes) {
  const auto tube = [&](double radius, int around, int along, const char* quads) {
    meshes.push_back({"ring tube, r = " + decimal(radius) + ", quads " + quads,
                      ringTube(radius, around, along), false});
  };
  tube(0.1, 12, 120, "1:1");
  tube(0.1, 40, 57, "7:1");
  tube(0.1, 60, 30, "20:1");
  tube(0.03, 48, 48, "33:1");
  tube(0.03, 12, 200, "2:1");
  for (const double stretch : {10.0, 100.0}) {
    meshes.push_back({"rough sheet, stretched " + decimal(stretch) + ":1",
                      moved(roughSheet(3000, 0.2, 9), Vec3(stretch, 1, 1), Vec3::Zero()), false});
  }
  meshes.push_back({"rough sheet, sheared 10", sheared(roughSheet(3000, 0.2, 9), 10), false});
  meshes.push_back({"rough sheet", roughSheet(3000, 0.2, 9), false});
  meshes.push_back({"very rough sheet", roughSheet(3000, 0.6, 9), false});
  meshes.push_back({"sphere, stretched 30:1",
                    moved(relaxedSphere(4000, 3), Vec3(30, 1, 1), Vec3::Zero()), false});
  meshes.push_back({"torus, stretched 8:1", irregularTorus(4000, 8, 3), false});
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    for (const bool needles : {true, false}) {
      meshes.push_back(
          {std::string("rough sheet, ") + (needles ? "needles " : "caps ") + decimal(height),
           withSlivers(roughSheet(1500, 0.2, 9), height, needles), false});
    }
  }
}

void addSharp(Array<GalleryMesh>& meshes) {
  meshes.push_back({"crumpled sheet, 6 folds", crumpledSheet(4000, 6, 3), false});
  meshes.push_back({"crumpled sheet, 20 folds", crumpledSheet(4000, 20, 4), false});
  meshes.push_back({"box", creasedBox(Vec3(1, 1, 1), 16, 0.2, 3), false});
  meshes.push_back({"flat box", creasedBox(Vec3(1, 1, 0.125), 24, 0.2, 3), false});
  meshes.push_back({"plate with 50 holes", plateWithHoles(21, 11), false});
  for (const double turn : {0.1, 0.5, 0.9}) {
    meshes.push_back({"cone of " + decimal(360 * turn) + " degrees",
                      flatCone(24, 2 * kPi * turn, 3).soup, false});
  }
  meshes.push_back({"cylinder of 12 sides", flatCylinder(12, 6, 3).soup, false});
  meshes.push_back({"cone, valence 1000", wheel(1000, 2, 0.5), false});
  meshes.push_back({"cone, valence 10000", wheel(10'000, 0, 0.5), false});
}

void addSmooth(Array<GalleryMesh>& meshes) {
  const TriangleSoup sphere = randomSphere(3000, 5);
  meshes.push_back({"sphere, random", sphere, false});
  meshes.push_back({"sphere, relaxed", relaxedSphere(3000, 5), false});
  meshes.push_back({"sphere, jittered UV", jitteredUvSphere(3000, 5), false});
  meshes.push_back({"torus", irregularTorus(4000, 1, 3), false});
  meshes.push_back({"genus 3", makeShape(Shape::kGenus3, 4000), false});
  meshes.push_back({"knot", makeShape(Shape::kKnot, 4000), false});
  meshes.push_back(
      {"sphere, random, x 1e-6", moved(sphere, Vec3::Constant(1e-6), Vec3::Zero()), false});
  meshes.push_back(
      {"sphere, random, x 1e6", moved(sphere, Vec3::Constant(1e6), Vec3::Zero()), false});
  meshes.push_back({"sphere, random, 1e4 from the origin",
                    moved(sphere, Vec3::Ones(), Vec3(1e4, -5e3, 3e3)), false});
}

}  // namespace

TriangleSoup crumpledSheet(int triangles, int folds, uint64_t seed) {
  TriangleSoup soup = tessellatedPlane(PlaneTessellation::kRandomDelaunay, triangles, seed);
  Random random(seed);
  for (int fold = 0; fold < folds; ++fold) {
    const Vec2 normal = unitVector(random.uniform(0, 2 * kPi));
    const double offset = random.uniform(0.2, 0.8) * (normal.x() + normal.y());
    const double slope = random.uniform(0.5, 2) * (random.uniform() < 0.5 ? -1 : 1);
    for (Vec3& p : soup.positions) {
      p.z() += slope * std::abs(normal.x() * p.x() + normal.y() * p.y() - offset);
    }
  }
  return soup;
}

GalleryMesh randomSheet(uint64_t seed) {
  constexpr int kTriangles = 3000;
  constexpr PlaneTessellation kKinds[] = {PlaneTessellation::kJitteredDelaunay,
                                          PlaneTessellation::kRandomDelaunay,
                                          PlaneTessellation::kStretchedRandom};
  Random random(seed);
  const PlaneTessellation kind = kKinds[random.index(3)];
  const double noise = random.uniform(0.05, 0.6);
  const double stretch = std::pow(30, random.uniform());
  const double shear = random.uniform(0, 4);
  // The last kind has cells of 20:1 in the unit square.
  const double cell = kind == PlaneTessellation::kStretchedRandom ? 20 : 1;
  const double edge = std::sqrt(2 / (kTriangles * cell));
  TriangleSoup soup = tessellatedPlane(kind, kTriangles, seed);
  for (Vec3& p : soup.positions) p.z() = random.uniform(-noise, noise) * edge;
  const std::string name = std::string(tessellationName(kind)) + ", noise " + decimal(noise) +
                           ", stretched " + decimal(stretch) + ":1, sheared " + decimal(shear);
  return {name, sheared(moved(std::move(soup), Vec3(stretch / cell, 1, 1), Vec3::Zero()), shear),
          false};
}

TriangleSoup fanSquares(int side, int q, double jitter, uint64_t seed) {
  TriangleSoup soup;
  Random random(seed);
  SharedVertices shared(soup);
  // Vertices on the grid's lines, moved along them, by their original place.
  std::map<int, Vec3> places;
  const auto onLine = [&](int x, int y, int dx, int dy) {
    const int before = soup.positions.count();
    const int v = shared.at(Vec3(x, y, 0) / q);
    if (v == before) {
      const bool isCorner = x % q == 0 && y % q == 0;
      const double move = isCorner ? 0 : jitter * random.uniform(-0.5, 0.5) / q;
      places[v] = Vec3(x, y, 0) / q + move * Vec3(dx, dy, 0);
    }
    return v;
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      Array<int> rim;
      constexpr int kDirections[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
      int x = i * q;
      int y = j * q;
      for (const auto& [dx, dy] : kDirections) {
        for (int k = 0; k < q; ++k) {
          rim.push_back(onLine(x, y, std::abs(dx), std::abs(dy)));
          x += dx;
          y += dy;
        }
      }
      const int middle = soup.positions.count();
      soup.positions.push_back(Vec3(i + 0.5 + 0.5 * jitter * random.uniform(-1, 1),
                                    j + 0.5 + 0.5 * jitter * random.uniform(-1, 1), 0));
      for (int k = 0; k < rim.count(); ++k) {
        soup.triangles.push_back({middle, rim[k], rim[(k + 1) % rim.count()]});
      }
    }
  }
  for (const auto& [v, place] : places) soup.positions[v] = place;
  return soup;
}

TriangleSoup ringTube(double radius, int around, int along) {
  TriangleSoup soup;
  for (int i = 0; i < along; ++i) {
    const Vec2 u = unitVector(2 * kPi * i / along);
    for (int j = 0; j < around; ++j) {
      const Vec2 w = radius * unitVector(2 * kPi * j / around);
      soup.positions.push_back(Vec3(u.x() * (1 + w.x()), u.y() * (1 + w.x()), w.y()));
    }
  }
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const int a = i * around + j;
      const int b = (i + 1) % along * around + j;
      const int c = (i + 1) % along * around + (j + 1) % around;
      const int d = i * around + (j + 1) % around;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  }
  return soup;
}

TriangleSoup plateWithHoles(int columns, int rows) {
  TriangleSoup soup;
  SharedVertices vertices(soup);
  const auto isFilled = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < columns && j < rows && !(i % 2 == 1 && j % 2 == 1);
  };
  const auto square = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int number[4] = {vertices.at(a), vertices.at(b), vertices.at(c), vertices.at(d)};
    soup.triangles.push_back({number[0], number[1], number[2]});
    soup.triangles.push_back({number[0], number[2], number[3]});
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (!isFilled(i, j)) continue;
      const auto at = [&](int x, int y, int z) { return Vec3(i + x, j + y, z); };
      square(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
      square(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
      if (!isFilled(i - 1, j)) square(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
      if (!isFilled(i + 1, j)) square(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
      if (!isFilled(i, j - 1)) square(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
      if (!isFilled(i, j + 1)) square(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
    }
  }
  return soup;
}

TriangleSoup wheel(int valence, int rings, double height) {
  TriangleSoup soup;
  soup.positions.push_back(Vec3(0, 0, height));
  for (int ring = 1; ring <= rings + 1; ++ring) {
    for (int i = 0; i < valence; ++i) {
      const Vec2 u = ring * unitVector(2 * kPi * i / valence);
      soup.positions.push_back(Vec3(u.x(), u.y(), height * (1 - ring)));
    }
  }
  for (int i = 0; i < valence; ++i) {
    const int j = (i + 1) % valence;
    soup.triangles.push_back({0, 1 + i, 1 + j});
    for (int ring = 0; ring < rings; ++ring) {
      const int a = 1 + ring * valence;
      soup.triangles.push_back({a + i, a + valence + i, a + valence + j});
      soup.triangles.push_back({a + i, a + valence + j, a + j});
    }
  }
  return soup;
}

TriangleSoup wideGrid(int columns, int rows) {
  TriangleSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int k = 0; k <= columns; ++k) soup.positions.push_back(Vec3(std::pow(10, k / 2.0), j, 0));
  }
  soup.triangles = gridTriangles(columns, rows, [](int i, int j) { return (i + j) % 2 == 0; });
  return soup;
}

Array<GalleryMesh> gallery() {
  Array<GalleryMesh> meshes;
  addFlat(meshes);
  addThin(meshes);
  addSharp(meshes);
  addSmooth(meshes);
  return meshes;
}

TriangleMesh galleryMesh(const std::string& name) {
  static const Array<GalleryMesh> meshes = gallery();
  for (const GalleryMesh& example : meshes) {
    if (example.name == name) return buildMesh(example.soup.positions, example.soup.triangles);
  }
  throw std::runtime_error("the gallery has no mesh '" + name + "'");
}

}  // namespace karcher

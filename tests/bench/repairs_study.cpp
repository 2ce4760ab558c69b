// Defects of meshes, alone and in pairs, on each built-in shape: their repairs, the time for these,
// and whether points keep their place and distances reach all of a component. Prints Markdown.
//
//   repairs_study [TRIANGLES]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "generators/defects.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "rcm/field_options.h"

namespace karcher {
namespace {

constexpr int kOfEach = 20;
/// The seed of the next mesh: each has a generator of its own.
uint64_t seed = 1000;

struct Row {
  int made = 0;
  int opened = 0;
  int exactCounts = 0;
  double milliseconds = 0;
  double moved = 0;
  int unreached = 0;
  std::map<std::string, int> repairs;
  std::set<std::string> refusals;
};

Vec3 placeInSoup(const TriangleSoup& soup, int face, const Vec3& bary) {
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 3; ++k) place += bary[k] * soup.positions[soup.triangles[face][k]];
  return place;
}

/// The largest distance of points of the input triangles from their place, in both directions.
double farthestMoved(const TriangleSoup& soup, const ImportedMesh& imported) {
  double farthest = 0;
  for (int t = 0; t < soup.triangles.count(); ++t) {
    const Vec3 bary(0.2, 0.3, 0.5);
    const Vec3 place = placeInSoup(soup, t, bary);
    const SurfacePoint point = toEngine(imported.numbering, imported.mesh, t, bary);
    const SurfacePoint back = toInput(imported.numbering, point);
    farthest = std::max({farthest, (position(imported.mesh, point) - place).norm(),
                         (placeInSoup(soup, back.face, back.bary) - place).norm()});
  }
  return farthest / boundingBoxDiagonal(imported.mesh);
}

/// Vertices of the first vertex's component without a finite distance.
int countUnreached(TriangleMesh mesh) {
  const Array<int> component = componentOfVertices(mesh);
  Surface surface(std::move(mesh));
  const Array<double> distances =
      distancesFrom(*makeDistanceSolver(surface, {}), vertexPoint(surface.mesh(), 0),
                    surface.mesh().vertexCount());
  int unreached = 0;
  for (int v = 0; v < distances.count(); ++v) {
    unreached += component[v] == component[0] && !std::isfinite(distances[v]);
  }
  return unreached;
}

void open(const TriangleSoup& soup, const std::map<std::string, int>& expected, Row& row) {
  ++row.made;
  const auto start = std::chrono::steady_clock::now();
  try {
    ImportedMesh imported = importMesh(soup);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    row.milliseconds = std::max(row.milliseconds, took.count());
    ++row.opened;
    std::map<std::string, int> found;
    for (const Repair& repair : imported.repairs) found[repairName(repair.kind)] += repair.count;
    for (const auto& [name, count] : found) row.repairs[name] += count;
    row.exactCounts += found == expected;
    row.moved = std::max(row.moved, farthestMoved(soup, imported));
    row.unreached += countUnreached(std::move(imported.mesh));
  } catch (const Error& error) {
    row.refusals.insert(error.what());
  }
}

void print(const std::string& name, const Row& row) {
  std::string repairs;
  for (const auto& [kind, count] : row.repairs) {
    repairs += (repairs.empty() ? "" : ", ") + kind + " " + std::to_string(count);
  }
  std::printf("| %s | %d of %d | %d | %s | %.0f | %.0e | %d |\n", name.c_str(), row.opened,
              row.made, row.exactCounts, repairs.c_str(), row.milliseconds, row.moved,
              row.unreached);
  for (const std::string& sentence : row.refusals) std::printf("refused: %s\n", sentence.c_str());
  std::fflush(stdout);
}

void study(int triangles) {
  std::printf(
      "Meshes of about %d triangles, %d of each defect: how many were opened, how many with a "
      "report that counts each defect under its own repair and nothing else, all repairs, the "
      "longest time to open one (ms), the farthest that a point moved (of the diagonal), vertices "
      "that no distance reached.\n\n"
      "| defect | opened | counts right | repairs | ms | moved | unreached |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n",
      triangles, kOfEach);
  for (const Defect defect : kDefects) {
    Row row;
    for (const Shape shape : kShapes) {
      DefectiveMesh mesh(makeShape(shape, triangles), ++seed);
      const int count = mesh.add(defect, kOfEach);
      open(mesh.soup(), {{repairName(repairOf(defect)), count}}, row);
    }
    print(defectName(defect), row);
  }
  for (const Defect defect : kDefects) {
    Row row;
    for (const Shape shape : kShapes) {
      for (const Defect other : kDefects) {
        if (other == defect) continue;
        DefectiveMesh mesh(makeShape(shape, triangles), ++seed);
        std::map<std::string, int> expected;
        for (const Defect one : {std::min(defect, other), std::max(defect, other)}) {
          expected[repairName(repairOf(one))] += mesh.add(one, kOfEach);
        }
        open(mesh.soup(), expected, row);
      }
    }
    print(std::string(defectName(defect)) + ", and each of the others", row);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::study(argc > 1 ? std::atoi(argv[1]) : 20'000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

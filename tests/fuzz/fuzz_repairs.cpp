#include <algorithm>
#include <cmath>
#include <cstdio>

#include "distance/find_path.h"
#include "distance/window_distance.h"
#include "fuzz/fuzz_checks.h"
#include "rcm/field_options.h"

namespace karcher {
namespace {

constexpr int kMostVertices = 48;
constexpr int kMostTriangles = 96;
/// The relative error of a path's length by rounding. Distances of exact windows are up to 1.2e-8
/// below straight lines if triangles are needles.
constexpr double kRounding = 1e-7;
/// The part by which fast distances, which are near exact ones, may be too short (docs/gallery.md).
constexpr double kFastError = 0.05;

struct Case {
  TriangleSoup soup;
  ImportOptions options;
};

/// Vertices of a coarse lattice, many of them equal; some lie 10^-1 to 10^-15 of its unit off.
Case readCase(Bytes given) {
  FuzzBytes bytes(given);
  Case made;
  made.options.repair = bytes.byte() % 8 != 7;
  constexpr double kWelds[] = {-1, -1, -1, 0, 1e-9, 1e-3, 0.1, 3};
  made.options.weld = kWelds[bytes.index(8)];
  const int side = 2 + bytes.index(15);
  constexpr double kScales[] = {1, 1, 1, 1e-6, 1e6, 1e-100, 1e100, 1e3};
  const double scale = kScales[bytes.index(8)];
  const Vec3 offset = bytes.byte() % 4 == 3 ? Vec3(scale * 1e4, 0, 0) : Vec3(0, 0, 0);
  const int vertices = 3 + bytes.index(kMostVertices - 2);
  for (int v = 0; v < vertices; ++v) {
    Vec3 place;
    for (int k = 0; k < 3; ++k) place[k] = bytes.index(side);
    const int moved = bytes.index(64);
    if (moved > 0 && moved < 46) place[moved % 3] += std::pow(10, -1 - moved / 3);
    if (moved == 63) place.x() = std::numeric_limits<double>::quiet_NaN();
    made.soup.positions.push_back(scale * place + offset);
  }
  while (!bytes.isAtEnd() && made.soup.triangles.count() < kMostTriangles) {
    Triangle triangle;
    // One index is too large.
    for (int k = 0; k < 3; ++k) {
      const int corner = bytes.byte();
      triangle[k] = corner == 255 ? vertices : corner % vertices;
    }
    made.soup.triangles.push_back(triangle);
  }
  return made;
}

Vec3 placeInSoup(const TriangleSoup& soup, int face, const Vec3& bary) {
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 3; ++k) place += bary[k] * soup.positions[soup.triangles[face][k]];
  return place;
}

/// The largest distance by which vertices moved onto others.
double farthestWeld(const Case& made, const ImportedMesh& imported) {
  double farthest = 0;
  for (int v = 0; v < made.soup.positions.count(); ++v) {
    const int to = imported.numbering.engineVertex[v];
    if (to < 0) continue;
    farthest = std::max(farthest, (imported.mesh.positions[to] - made.soup.positions[v]).norm());
  }
  return farthest;
}

void checkPlaces(const Case& made, const ImportedMesh& imported) {
  const double diagonal = boundingBoxDiagonal(imported.mesh);
  const double tolerance = 1e-9 * diagonal + 2 * farthestWeld(made, imported);
  for (int t = 0; t < made.soup.triangles.count(); ++t) {
    const Vec3 bary(0.2, 0.3, 0.5);
    SurfacePoint point;
    try {
      point = toEngine(imported.numbering, imported.mesh, t, bary);
    } catch (const Error& error) {
      expect(error.code() == ErrorCode::kBadIndex, error.what());  // it lies apart from all others
      continue;
    }
    expectOnSurface(imported.mesh, point);
    const SurfacePoint back = toInput(imported.numbering, point);
    const Vec3 place = position(imported.mesh, point);
    expect((placeInSoup(made.soup, back.face, back.bary) - place).norm() <= tolerance,
           "a point comes back elsewhere");
    if (imported.numbering.engineFace[t] < 0) continue;  // omitted, or cut into parts
    expect((place - placeInSoup(made.soup, t, bary)).norm() <= tolerance,
           "a point is not at its place");
  }
}

void checkDistances(TriangleMesh made) {
  Surface surface(std::move(made));
  const TriangleMesh& mesh = surface.mesh();
  const double diagonal = surface.geometry().diagonal;
  const double rounding = kRounding * diagonal;
  const int stride = std::max(1, mesh.vertexCount() / 3);
  Array<Array<double>> from;
  Array<int> sources;
  for (int v = 0; v < mesh.vertexCount(); v += stride) {
    sources.push_back(v);
    for (const Solver solver : {Solver::kExact, Solver::kFast}) {
      const auto distance = makeDistanceSolver(surface, {Method::kKarcher, solver, 6});
      const Array<double> lengths =
          distancesFrom(*distance, vertexPoint(mesh, v), mesh.vertexCount());
      for (int w = 0; w < mesh.vertexCount(); ++w) {
        const bool isReached = std::isfinite(lengths[w]);
        expect(isReached == (surface.component(v) == surface.component(w)),
               "what a distance reaches is not the component");
        if (!isReached) continue;
        const double straight = (mesh.positions[v] - mesh.positions[w]).norm();
        const double missing = solver == Solver::kFast ? kFastError * straight : 0;
        expect(lengths[w] >= straight - missing - rounding,
               "a distance is shorter than the straight line by " +
                   inSentence((straight - lengths[w]) / diagonal) + " of the diagonal");
      }
      if (solver == Solver::kExact) from.push_back(lengths);
    }
  }
  for (int i = 0; i < sources.count(); ++i) {
    for (int j = 0; j < i; ++j) {
      const double there = from[i][sources[j]];
      const double back = from[j][sources[i]];
      expect((there == kInfinity && back == kInfinity) || std::abs(there - back) <= rounding,
             "a distance is another back, by " + inSentence((there - back) / diagonal) +
                 " of the diagonal");
    }
  }
  FindPathWorkspace workspace;
  SurfacePath path;
  const SurfacePoint a{0, Vec3(0.25, 0.25, 0.5)};
  const SurfacePoint b{mesh.faceCount() - 1, Vec3(0.5, 0.25, 0.25)};
  const bool isFound = findPath(surface.geometry(), a, b, workspace, path);
  expect(isFound == (surface.component(mesh.corner(a.face, 0)) ==
                     surface.component(mesh.corner(b.face, 0))),
         "a path joins components, or is not found in one");
  if (isFound) expectOnSurface(mesh, path);
}

std::string asObj(const TriangleMesh& mesh) {
  std::string text;
  char line[128];
  for (const Vec3& p : mesh.positions) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const Triangle& t : mesh.faces) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

}  // namespace

void fuzzRepairs(Bytes bytes) {
  const Case made = readCase(bytes);
  ImportedMesh imported;
  try {
    imported = importMesh(made.soup, made.options);
  } catch (const Error& error) {
    return expectSentence(error);
  }
  expectSoundMesh(imported);
  checkPlaces(made, imported);
  try {
    expectSoundMesh(importObj(asObj(imported.mesh)));
  } catch (const Error& error) {
    // Separated edges coincide, and a file does not separate them. The next import welds them
    // again, rarely in another way, which may be one-sided.
    expect(error.code() == ErrorCode::kNotOrientable,
           "a mended mesh that was saved is refused: " + std::string(error.what()));
  }
  try {
    checkDistances(std::move(imported.mesh));
  } catch (const Error& error) {
    // The edge lengths are too far apart, or the surface is only rounding noise.
    expectSentence(error);
    expect(error.code() == ErrorCode::kBadArgument, error.what());
  }
}

}  // namespace karcher

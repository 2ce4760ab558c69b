#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/circle.h"
#include "curves/curve_value.h"
#include "curves/isoline.h"
#include "distance/shortest_path.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"

/// The deviation of circles from equidistance: the exact distance from the center to points all
/// along each circle, less the radius. The circles are those of n rational arcs by each method, and
/// the isolines of the exact distance, interpolated and exact, as in the paper's section 5.
///
///   circle_study [MESH.obj ...]
namespace karcher {
namespace {

constexpr int kCenters = 3;
constexpr int kPointsAlong = 100;
/// Radii as parts of the bounding box's diagonal.
constexpr double kRadii[] = {0.05, 0.15};

/// The largest and the mean deviation from equidistance, in parts of the radius.
struct Deviation {
  double largest = 0;
  double sum = 0;
  int count = 0;

  void add(const Geometry& geometry, const SurfacePoint& center, double radius,
           const Array<SurfacePoint>& line) {
    const SurfacePath path = pathThrough(*geometry.mesh, line);
    for (int i = 0; i < kPointsAlong; ++i) {
      const double length = path.length() * (i + 0.5) / kPointsAlong;
      const SurfacePoint point = pointAlong(*geometry.mesh, path, length);
      const double off = std::abs(shortestPath(geometry, center, point).length() - radius) / radius;
      largest = std::max(largest, off);
      sum += off;
      ++count;
    }
  }
};

template <class Add>
void row(const char* name, const Add& add) {
  Deviation deviation;
  std::string refused;
  try {
    add(deviation);
  } catch (const Error& error) {
    refused = error.what();
  }
  if (deviation.count == 0) {
    std::printf("| %s | - | - | %s |\n", name, refused.c_str());
  } else {
    std::printf("| %s | %.2e | %.2e | %s |\n", name, deviation.sum / deviation.count,
                deviation.largest, refused.c_str());
  }
  std::fflush(stdout);
}

void study(const std::string& name, TriangleMesh mesh) {
  Surface surface(std::move(mesh));
  const Geometry& geometry = surface.geometry();
  Random random(4);
  Array<SurfacePoint> centers;
  for (int i = 0; i < kCenters; ++i) centers.push_back(randomPoint(surface.mesh(), random));
  for (const double part : kRadii) {
    const double radius = part * geometry.diagonal;
    std::printf("\n%s, %d triangles, radius %.2f of the diagonal = %.1f mean edges\n\n",
                name.c_str(), surface.mesh().faceCount(), part, radius / geometry.meanEdge);
    std::printf("| circle | mean deviation / radius | largest | refused |\n");
    std::printf("| --- | --- | --- | --- |\n");
    struct Fields {
      const char* name;
      FieldOptions options;
      int levels = 0;
    };
    const FieldOptions fast{Method::kKarcher, Solver::kFast, 6};
    const Fields allFields[] = {{"log, fast", fast},
                                {"log, fast, levels that fit", fast, kAutomaticLevels},
                                {"log, exact", {Method::kKarcher, Solver::kExact, 6}},
                                {"paper, exact", {Method::kPaper, Solver::kExact, 6}}};
    for (const Fields& fields : allFields) {
      for (const int arcs : {3, 5, 7, 12, 24}) {
        const std::string title = std::to_string(arcs) + " arcs, " + fields.name;
        row(title.c_str(), [&](Deviation& deviation) {
          for (const SurfacePoint& center : centers) {
            const GeodesicCircle circle =
                traceCircle(surface, center, radius, {arcs, 32, fields.options, fields.levels});
            for (const JoinedPath& path : circle.paths) {
              deviation.add(geometry, center, radius, path.line.points);
            }
          }
        });
      }
    }
    row("isoline, linear", [&](Deviation& deviation) {
      for (const SurfacePoint& center : centers) {
        WindowDistance distance(geometry);
        distance.setSource(center);
        distance.grow(kInfinity);
        Array<double> values;
        for (int v = 0; v < surface.mesh().vertexCount(); ++v)
          values.push_back(distance.distance(v));
        for (const Isoline& line : linearIsolines(surface.mesh(), values, radius)) {
          deviation.add(geometry, center, radius, line.points);
        }
      }
    });
    row("isoline, exact", [&](Deviation& deviation) {
      for (const SurfacePoint& center : centers) {
        for (const Isoline& line : exactIsolines(geometry, center, radius, 1e-6)) {
          deviation.add(geometry, center, radius, line.points);
        }
      }
    });
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    study("sphere", importMesh(icosphere(8)).mesh);
    study("sphere", importMesh(icosphere(32)).mesh);
    for (int i = 1; i < argc; ++i) study(argv[i], loadBenchMesh(argv[i], "").mesh);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

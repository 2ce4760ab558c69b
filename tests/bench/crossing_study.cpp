#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/curve_shapes.h"

/// The crossings of edges of uniform cubic B-splines (128 samples a segment, the fast solver): the
/// number of crossings, the number of geodesics in their place, the cost of a crossing, and the
/// distance in mean edges from the edge's point to the ends of the fields of the two faces.
///
///   crossing_study MESH.obj POINTS.txt [MESH.obj POINTS.txt ...]
namespace karcher {
namespace {

constexpr int kSamples = 128;
constexpr FieldOptions kField{Method::kKarcher, Solver::kFast, 6};

/// The distance of the zero of a face's own field from a point.
double gap(const Geometry& geometry, FieldBlend& fields, Weights weights, int face,
           const Vec3& point) {
  const Vec3 direction = fields.blend(face, weights).zeroDirection();
  const Vec3 zero = position(*geometry.mesh, {face, direction / direction.sum()});
  return (zero - point).norm() / geometry.meanEdge;
}

void study(const std::string& meshPath, const std::string& pointsPath) {
  BenchMesh input = loadBenchMesh(meshPath, pointsPath);
  Surface surface(std::move(input.mesh));
  const TriangleMesh& mesh = surface.mesh();
  Curve curve(surface, ofLevelZero({CurveKind::kBSpline}, kSamples, kField), input.points);
  Array<double> gaps;
  int filled = 0;
  double ms = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    const BasisWriter basis = [&](double t, Array<double>& weights) {
      weights = curve.weights(j, t);
    };
    SegmentFields fields(surface, curve.fieldsOf(j));
    const Array<CurveSample>& samples = curve.samples(j);
    CrossingWorkspace workspace;
    EdgeCrossings crossings(fields, basis, kField.method, workspace);
    for (int i = 1; i < samples.count(); ++i) {
      Array<SurfacePoint> path;
      bool whole = false;
      ms += timed([&] { whole = crossings.append(samples[i - 1], samples[i], path); });
      filled += !whole;
      if (!whole) continue;
      for (const CurveSample& found : crossings.found()) {
        const PointLocation place = locate(mesh, found.point);
        if (place.simplex != Simplex::kEdge || mesh.twin[place.halfedge] < 0) continue;
        const Array<double> weights = curve.weights(j, found.t);
        const Vec3 point = position(mesh, found.point);
        for (const int face : {place.face, faceOf(mesh.twin[place.halfedge])}) {
          gaps.push_back(gap(surface.geometry(), fields.blend, weights, face, point));
        }
      }
    }
  }
  double squares = 0;
  for (const double g : gaps) squares += g * g;
  const int count = gaps.count() / 2;
  std::printf("| %s | %d | %d | %d | %.0f | %.1e | %.1e |\n",
              meshPath.substr(meshPath.rfind('/') + 1).c_str(), mesh.faceCount(), count, filled,
              1e6 * ms / count, std::sqrt(squares / gaps.count()), quantile(gaps, 1));
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) {
    std::fprintf(stderr, "usage: crossing_study MESH.obj POINTS.txt [MESH.obj POINTS.txt ...]\n");
    return 1;
  }
  try {
    std::printf(
        "| mesh | triangles | crossings | filled | ns a crossing | gap, RMS | gap, max |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
    for (int i = 1; i + 1 < argc; i += 2) karcher::study(argv[i], argv[i + 1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/accuracy.h"
#include "generators/curve_shapes.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "measures/plane_deviation.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"

/// The distance of curves of some levels from the one of level 0 on smooth surfaces, as their
/// control polygon shrinks by halves: it falls by the third power of the size, down to the mesh's
/// own error. Also their distance from the Euclidean curve on the plane, which is rounding.
///
///   refinement_study [TRIANGLES]
namespace karcher {
namespace {

constexpr uint64_t kSeed = 5;
constexpr int kSamples = 65;
constexpr int kSizes = 5;
constexpr double kLargest = 0.5;  ///< the approximate length of the largest leg
constexpr int kLevels[] = {1, 2, 3, 4, kAutomaticLevels};

struct Example {
  std::string name;
  SmoothSurface smooth;
  TriangleSoup soup;
  Vec3 start;
};

/// A cubic Bezier polygon whose legs are geodesics of about this length, turning left and right.
Array<Vec3> polygonOn(const SmoothSurface& smooth, const Vec3& start, double leg) {
  Array<Vec3> points = {smooth.project(start)};
  Vec3 ahead = Vec3(0.3, 0.9, 0.4);
  for (const double turn : {0.0, 1.0, -0.8}) {
    const Vec3 p = points.back();
    const Vec3 normal = smooth.normal(p);
    const Vec3 flat = (ahead - ahead.dot(normal) * normal).normalized();
    const Vec3 way = std::cos(turn) * flat + std::sin(turn) * normal.cross(flat);
    points.push_back(smooth.exp(p, leg * way));
    // The next leg continues in about the same direction.
    ahead = -smooth.log(points.back(), p);
  }
  return points;
}

/// The samples of the curve on the mesh, moved onto the smooth surface.
Array<Vec3> samplesOf(Surface& surface, const SmoothSurface& smooth,
                      const Array<SurfacePoint>& points, int levels) {
  CurveOptions options =
      ofLevelZero({CurveKind::kBezier}, kSamples, {Method::kKarcher, Solver::kExact, 6});
  options.levels = levels;
  const Curve curve(surface, options, points);
  Array<Vec3> places;
  for (const CurveSample& sample : curve.samples(0)) {
    places.push_back(smooth.project(position(surface.mesh(), sample.point)));
  }
  return places;
}

/// The curve of means on the smooth surface itself.
Array<Vec3> trueSamples(const SmoothSurface& smooth, const Array<Vec3>& points) {
  Array<Vec3> places;
  Vec3 start = points[0];
  for (int i = 0; i < kSamples; ++i) {
    const double t = static_cast<double>(i) / (kSamples - 1);
    const double s = 1 - t;
    start =
        smoothCenter(smooth, points, {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t}, start);
    places.push_back(start);
  }
  return places;
}

double largestDistance(const Array<Vec3>& a, const Array<Vec3>& b) {
  double largest = 0;
  for (int i = 0; i < a.count(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

double lengthOf(const Array<Vec3>& line) {
  double sum = 0;
  for (int i = 1; i < line.count(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/// Prints, over all kinds of curves with levels, the largest distance from the Euclidean curve.
void studyPlanes(int triangles) {
  std::printf(
      "\nOn the plane: the largest distance of samples from the Euclidean curve, as a part of the "
      "bounding box, over all kinds of curves that take levels.\n\n"
      "| tessellation |");
  for (int levels = 0; levels <= kMostLevels; ++levels) std::printf(" %d |", levels);
  std::printf(" farthest |\n| --- |");
  for (int levels = 0; levels <= kMostLevels + 1; ++levels) std::printf(" --- |");
  std::printf("\n");
  for (const AccuracyFamily& family : accuracyFamilies()) {
    if (family.name.rfind("plane", 0) != 0) continue;
    Surface surface(importMesh(family.mesh(triangles)).mesh);
    Array<SurfacePoint> points;
    for (const Vec3& p : family.points) points.push_back(nearestPoint(surface.mesh(), p));
    std::printf("| %s |", family.name.c_str());
    std::string farthest;
    double most = -1;
    for (int levels = 0; levels <= kMostLevels; ++levels) {
      double largest = 0;
      for (const CurveShape& shape : everyShape(points.count())) {
        if (!takesLevels(shape.kind)) continue;
        CurveOptions options = ofLevelZero(shape, kSamples, {});
        options.levels = levels;
        const double part = planeDeviation(surface, options, points) / surface.geometry().diagonal;
        largest = std::max(largest, part);
        if (part <= most) continue;
        most = part;
        farthest = describe(shape);
      }
      std::printf(" %.1e |", largest);
    }
    std::printf(" %s |\n", farthest.c_str());
    std::fflush(stdout);
  }
}

void study(const Example& example) {
  Surface surface(importMesh(example.soup).mesh);
  double before[std::size(kLevels)] = {};
  double leg = kLargest;
  for (int size = 0; size < kSizes; ++size, leg /= 2) {
    Array<SurfacePoint> points;
    Array<Vec3> onSurface;
    for (const Vec3& p : polygonOn(example.smooth, example.start, leg)) {
      points.push_back(nearestPoint(surface.mesh(), p));
      onSurface.push_back(example.smooth.project(position(surface.mesh(), points.back())));
    }
    const Array<Vec3> means = samplesOf(surface, example.smooth, points, 0);
    const double length = lengthOf(means);
    const double error = largestDistance(means, trueSamples(example.smooth, onSurface));
    std::printf("| %s | %.4f | %.1e |", example.name.c_str(), leg, error);
    for (int i = 0; i < static_cast<int>(std::size(kLevels)); ++i) {
      const double moved =
          largestDistance(means, samplesOf(surface, example.smooth, points, kLevels[i]));
      std::printf(" %.1e (%.3f %%)", moved, 100 * moved / length);
      if (size > 0 && moved > 0) std::printf(" %.1f", std::log2(before[i] / moved));
      std::printf(" |");
      before[i] = moved;
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 80'000;
  try {
    std::printf(
        "Cubic Bezier curves: the largest distance of samples from those of level 0, as a part of "
        "the curve's length in brackets, and the power of the size with which it fell. Mesh: the "
        "distance of level 0 from the curve on the smooth surface.\n\n"
        "| surface | leg | mesh | 1 level | 2 levels | 3 levels | 4 levels | auto |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    const Vec3 onTorus(kTorusMajor + 0.3, -0.3, 0.1);
    study({"sphere",
           smoothSphere(),
           icosphere(static_cast<int>(std::sqrt(triangles / 20.0))),
           {0.9, -0.3, 0.2}});
    study({"sphere, irregular", smoothSphere(), relaxedSphere(triangles, kSeed), {0.9, -0.3, 0.2}});
    study({"torus", smoothTorus(kTorusMajor, kTorusMinor), makeShape(Shape::kTorus, triangles),
           onTorus});
    study({"torus, irregular", smoothTorus(kTorusMajor, kTorusMinor),
           irregularTorus(triangles, 1, kSeed), onTorus});
    studyPlanes(triangles / 20);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

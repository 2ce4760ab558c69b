#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "generators/curve_shapes.h"
#include "generators/gallery.h"
#include "measures/allocations.h"
#include "measures/turning.h"
#include "mesh/mesh_import.h"
#include "smooth_shapes.h"

/// The smoothness of default curves where their pieces meet. The curves are random Bezier,
/// Catmull-Rom and B-spline curves with legs of .1 and .3 of the diagonal. At each joint of two
/// pieces the study takes the curve's first and second derivatives from both sides, by cubics
/// through four samples, and compares them. For comparison it does the same in the middle of
/// pieces, where the curve is one center of mass. Cubics are exact on the plane. The study
/// projects derivatives to the tangent plane of the surface.
///
/// With --memory the study instead measures the memory that a Bezier curve with legs of .3 takes
/// and holds, on a ring tube of --triangles triangles or on meshes from files.
///
///   joints_study [--polygons 8] [--triangles 80000] [--memory] [SHAPE | MESH.obj ...]
namespace karcher {
namespace {

constexpr double kSpacings[] = {0.1, 0.3};
/// The longest legs that fit on the saddle.
constexpr double kFarthestOnSaddle = 0.2;
/// The samples of a segment: pieces of up to 5 levels have the steps that the stencils need.
constexpr int kSamples = 513;
constexpr int kSteps = 8;

struct Options {
  int polygons = 8;
  int triangles = 80'000;
  bool memory = false;
  Array<std::string> names;
};

struct Derivatives {
  Vec3 first;
  Vec3 second;
};

/// The derivatives at the first of four points at steps of 1.
Derivatives derivatives(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {(-11 * a + 18 * b - 9 * c + 2 * d) / 6, 2 * a - 5 * b + 4 * c - d};
}

struct Joints {
  Array<double> kinks;  ///< kinks in degrees
  Array<double>
      leaps;  // leaps of the second derivative, as parts of the larger value of both sides
};

class Meter {
 public:
  explicit Meter(const TriangleMesh& mesh) : mesh_(&mesh), normals_(mesh) {}

  /// Compares both sides of sample `at`, by samples `step` apart.
  void compare(const Array<SurfacePoint>& samples, int at, int step, Joints& joints) const {
    const auto place = [&](int k) { return position(*mesh_, samples[at + k * step]); };
    Derivatives before = derivatives(place(0), place(-1), place(-2), place(-3));
    Derivatives after = derivatives(place(0), place(1), place(2), place(3));
    before.first = -before.first;
    const Vec3 normal = normals_.at(samples[at]);
    const auto flat = [&](const Vec3& v) -> Vec3 { return v - v.dot(normal) * normal; };
    const Vec3 u = flat(before.first);
    const Vec3 v = flat(after.first);
    joints.kinks.push_back(180 / kPi * std::atan2(u.cross(v).norm(), u.dot(v)));
    const Vec3 p = flat(before.second);
    const Vec3 q = flat(after.second);
    const double larger = std::max(p.norm(), q.norm());
    if (larger > 0) joints.leaps.push_back((q - p).norm() / larger);
  }

 private:
  const TriangleMesh* mesh_;
  SmoothNormals normals_;
};

Array<SurfacePoint> pointsOf(const Array<CurveSample>& samples) {
  Array<SurfacePoint> points;
  for (const CurveSample& sample : samples) points.push_back(sample.point);
  return points;
}

/// Measures the samples of both pieces, with the joint once; nothing if the pieces differ in their
/// numbers of samples.
void measure(const Curve& curve, const Meter& meter, Joints& joints, Joints& middles) {
  Array<Array<SurfacePoint>> pieces;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (int k = 0; k < curve.piecesPerSegment(); ++k) {
      pieces.push_back(pointsOf(curve.piece(j, k).samples()));
    }
  }
  for (int k = 0; k < pieces.count(); ++k) {
    const int last = pieces[k].count() - 1;
    const int step = last / kSteps;
    if (step == 0) continue;
    meter.compare(pieces[k], last / 2, step, middles);
    if (k + 1 == pieces.count() || pieces[k + 1].count() != last + 1) continue;
    Array<SurfacePoint> both = pieces[k];
    for (int i = 1; i <= last; ++i) both.push_back(pieces[k + 1][i]);
    meter.compare(both, last, step, joints);
  }
}

/// Prints the rows of a mesh on which legs of up to `farthest` of the diagonal fit.
void printRows(const std::string& name, Surface& surface, double farthest, int polygons) {
  struct Kind {
    const char* name;
    CurveKind kind;
    int points;
  };
  constexpr Kind kKinds[] = {{"Bezier", CurveKind::kBezier, 4},
                             {"Catmull-Rom", CurveKind::kCatmullRom, 6},
                             {"B-spline", CurveKind::kBSpline, 6}};
  const Meter meter(surface.mesh());
  for (const Kind& kind : kKinds) {
    for (const double spacing : kSpacings) {
      if (spacing > farthest) continue;
      Random random(3);
      Joints joints;
      Joints middles;
      Array<double> levels;
      for (int i = 0; i < polygons; ++i) {
        CurveOptions options = ofLevelZero({kind.kind}, kSamples, {});
        options.levels = kAutomaticLevels;
        const Curve curve(surface, options,
                          randomControlPolygon(surface.geometry(), random,
                                               {.points = kind.points, .spacing = spacing}));
        levels.push_back(curve.levels());
        measure(curve, meter, joints, middles);
      }
      const auto numbers = [](const Array<double>& values, double scale) {
        if (values.empty()) return std::string("-");
        char text[60];
        std::snprintf(text, sizeof text, "%.2g / %.2g / %.2g", scale * median(values),
                      scale * quantile(values, 0.95), scale * quantile(values, 1));
        return std::string(text);
      };
      std::printf("| %s | %d | %s | %g | %.1f | %d | %s | %s | %s | %s |\n", name.c_str(),
                  surface.mesh().faceCount(), kind.name, spacing, mean(levels),
                  joints.kinks.count(), numbers(joints.kinks, 1).c_str(),
                  numbers(middles.kinks, 1).c_str(), numbers(joints.leaps, 100).c_str(),
                  numbers(middles.leaps, 100).c_str());
      std::fflush(stdout);
    }
  }
}

void printMemory(const std::string& name, Surface& surface) {
  constexpr double kFarSpacing = 0.3;
  Random random(3);
  for (const char* which : {"first", "second"}) {
    const Array<SurfacePoint> points =
        randomControlPolygon(surface.geometry(), random, {.spacing = kFarSpacing});
    CurveOptions options = ofLevelZero({CurveKind::kBezier}, 128, {});
    options.levels = kAutomaticLevels;
    // The default could choose level 0, which has no refined curve.
    options.leastLevels = 1;
    const int64_t taken = bytesTakenSoFar();
    const int64_t held = bytesHeld();
    const Curve curve(surface, options, points);
    std::printf("| %s | %d | %s | %d | %.2f | %.2f |\n", name.c_str(), surface.mesh().faceCount(),
                which, curve.levels(), 1e-6 * static_cast<double>(bytesTakenSoFar() - taken),
                1e-6 * static_cast<double>(bytesHeld() - held));
    std::fflush(stdout);
  }
}

void study(const Options& options) {
  std::printf(
      options.memory
          ? "| mesh | triangles | curve | levels | takes in all, MB | holds, MB |\n"
            "| --- | --- | --- | --- | --- | --- |\n"
          : "| mesh | triangles | curve | spacing | levels | joints | kink, degrees | in pieces | "
            "leap of the second derivative, %% | in pieces |\n"
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const auto print = [&](const std::string& name, Surface& surface, double farthest = 1) {
    if (options.memory) {
      printMemory(name, surface);
    } else {
      printRows(name, surface, farthest, options.polygons);
    }
  };
  for (const std::string& name : options.names) {
    if (name.size() < 4 || name.substr(name.size() - 4) != ".obj") continue;
    Surface surface(studyMesh(name));
    print(meshName(name), surface);
  }
  if (options.memory && options.names.empty()) {
    // A ring tube has any size, unlike the meshes of the generators of uneven triangles.
    const int around = static_cast<int>(std::lround(std::sqrt(options.triangles / 4.0)));
    Surface surface(importMesh(ringTube(0.4, around, 2 * around)).mesh);
    print("ring tube", surface);
  }
  if (options.memory) return;
  for (const SmoothShape& shape : smoothShapes()) {
    const auto& names = options.names;
    if (!names.empty() && std::find(names.begin(), names.end(), shape.name) == names.end()) {
      continue;
    }
    Surface surface(importMesh(shape.mesh(options.triangles)).mesh);
    print(shape.name, surface, shape.name == "saddle" ? kFarthestOnSaddle : 1);
  }
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--memory") {
      options.memory = true;
    } else if (argument == "--polygons" && i + 1 < argc) {
      options.polygons = std::atoi(argv[++i]);
    } else if (argument == "--triangles" && i + 1 < argc) {
      options.triangles = std::atoi(argv[++i]);
    } else {
      options.names.push_back(argument);
    }
  }
  if (options.polygons < 1) throw std::runtime_error("--polygons takes at least 1");
  return options;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    study(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "generators/marching_tetrahedra.h"
#include "generators/plane.h"
#include "generators/smooth_surface.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/straightest.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/exact_minimum.h"
#include "rcm/mean.h"

/// The convergence of centers of mass on meshes of a smooth surface to the true ones: the root of
/// the mean square distance over random cases, in mean edges, and the order in the mean edge from
/// one size to the next. Beside the methods stand bounds of the mesh itself: the minimum, near the
/// true center, of the energy by exact distances of the mesh, smoothed by a quadratic fit over a
/// disk of .3, 1 and 2 mean edges. No estimator from distances on the mesh is likely to be better
/// than the best of these.
///
///   convergence_study [--cases N] [--sizes N,N,...] [PART_OF_A_NAME]
namespace karcher {
namespace {

constexpr uint64_t kSeed = 8;
constexpr int kPoints = 4;

struct Family {
  std::string name;
  SmoothSurface surface;
  std::function<TriangleSoup(int triangles)> mesh;
  double reach = 0.5;  // largest distance of the points from the middle of their case
  /// Whether a middle is far enough from the boundary.
  std::function<bool(const Vec3& middle)> fits = [](const Vec3&) { return true; };
};

Array<Family> families() {
  constexpr uint64_t kMeshSeed = 5;
  const SmoothSurface sphere = smoothSphere();
  const SmoothSurface torus = smoothTorus(kTorusMajor, kTorusMinor);
  const Vec3 halfAxes(1.4, 1, 0.7);
  constexpr double kHeight = 0.5;
  constexpr double kTorusReach = 0.3;
  const auto icosahedral = [](int triangles) {
    return icosphere(static_cast<int>(std::lround(std::sqrt(triangles / 20.0))));
  };
  const auto ellipsoid = [halfAxes](int triangles) {
    TriangleSoup soup = relaxedSphere(triangles, kMeshSeed);
    for (Vec3& p : soup.positions) p = halfAxes.cwiseProduct(p);
    return soup;
  };
  const auto saddle = [](int triangles) {
    TriangleSoup soup =
        tessellatedPlane(PlaneTessellation::kJitteredDelaunay, triangles, kMeshSeed);
    for (Vec3& p : soup.positions) {
      const double x = 2 * p.x() - 1;
      const double y = 2 * p.y() - 1;
      p = Vec3(x, y, kHeight * (x * x - y * y));
    }
    return soup;
  };
  return {
      {"sphere, icosahedral", sphere, icosahedral},
      {"sphere, relaxed", sphere, [](int n) { return relaxedSphere(n, kMeshSeed); }},
      {"sphere, random points", sphere, [](int n) { return randomSphere(n, kMeshSeed); }},
      {"sphere, marching tetrahedra", sphere, marchedSphere},
      {"torus, relaxed", torus, [](int n) { return irregularTorus(n, 1, kMeshSeed); }, kTorusReach},
      {"torus, stretched 8:1", torus, [](int n) { return irregularTorus(n, 8, kMeshSeed); },
       kTorusReach},
      {"saddle, jittered", smoothSaddle(kHeight), saddle, 0.4,
       [](const Vec3& p) { return std::max(std::abs(p.x()), std::abs(p.y())) < 0.5; }},
      {"ellipsoid, relaxed", smoothEllipsoid(halfAxes), ellipsoid, 0.4},
  };
}

struct Case {
  Array<Vec3> points;
  Array<double> weights;
};

Array<Case> chooseCases(const Family& family, int count) {
  Random random(kSeed);
  const auto coordinate = [&] { return random.uniform(-1, 1); };
  Array<Case> cases;
  while (cases.count() < count) {
    const Vec3 middle = family.surface.project(Vec3(coordinate(), coordinate(), coordinate()));
    if (!family.fits(middle)) continue;
    const Vec3 normal = family.surface.normal(middle);
    Case example;
    double sum = 0;
    for (int k = 0; k < kPoints; ++k) {
      Vec3 way(coordinate(), coordinate(), coordinate());
      way -= way.dot(normal) * normal;
      const double length = family.reach * random.uniform();
      example.points.push_back(family.surface.exp(middle, length * way.normalized()));
      example.weights.push_back(0.1 + random.uniform());
      sum += example.weights.back();
    }
    for (double& weight : example.weights) weight /= sum;
    cases.push_back(example);
  }
  return cases;
}

/// A case on a mesh of the surface.
struct Placed {
  Array<SurfacePoint> points;
  Array<double> weights;
  Vec3 truth;
};

Placed placed(const Family& family, const Surface& surface, const Case& example) {
  Placed result{{}, example.weights, {}};
  Array<Vec3> onSurface;
  for (const Vec3& p : example.points) {
    result.points.push_back(nearestPoint(surface.mesh(), p));
    onSurface.push_back(family.surface.project(position(surface.mesh(), result.points.back())));
  }
  result.truth = smoothCenter(family.surface, onSurface, example.weights, onSurface[0]);
  return result;
}

/// The minimum of a quadratic fitted to the energy by exact distances over a disk around this
/// minimum.
SurfacePoint fittedMinimum(const Geometry& geometry, const Placed& example, double radius,
                           SurfacePoint center) {
  constexpr int kRings = 2;
  constexpr int kOnRing = 12;
  constexpr int kMostSteps = 6;
  ExactEnergy energy(geometry, example.points, example.weights);
  for (int i = 0; i < kMostSteps; ++i) {
    Array<Vec2> vectors{Vec2::Zero()};
    for (int ring = 1; ring <= kRings; ++ring) {
      for (int k = 0; k < kOnRing; ++k) {
        vectors.push_back(ring * radius / kRings *
                          unitVector(2 * kPi * (k + 0.5 * ring) / kOnRing));
      }
    }
    Array<SurfacePoint> places;
    for (const Vec2& vector : vectors) {
      places.push_back(traceStraightest(geometry, center, vector, {}).path.end());
    }
    const Array<double> values = energy.at(center, radius, places);
    Eigen::MatrixXd terms(places.count(), 6);
    Eigen::VectorXd right(places.count());
    for (int k = 0; k < places.count(); ++k) {
      const Vec2 x = vectors[k] / radius;
      terms.row(k) << 1, x.x(), x.y(), x.x() * x.x() / 2, x.x() * x.y(), x.y() * x.y() / 2;
      right[k] = values[k];
    }
    const Eigen::VectorXd q = terms.colPivHouseholderQr().solve(right);
    const double determinant = q[3] * q[5] - q[4] * q[4];
    Vec2 step = Vec2(q[4] * q[2] - q[5] * q[1], q[4] * q[1] - q[3] * q[2]) / determinant * radius;
    if (step.norm() > radius) step *= radius / step.norm();
    center = traceStraightest(geometry, center, step, {}).path.end();
    if (step.norm() < 1e-5 * geometry.meanEdge) break;
  }
  return center;
}

using Estimator = std::function<SurfacePoint(Surface&, const Placed&)>;

Estimator byFields(Method method, Solver solver) {
  return [method, solver](Surface& surface, const Placed& example) {
    MeanOptions options;
    options.field = {method, solver, 6};
    options.isChecked = false;
    return centerOfMass(surface, example.points, example.weights, options).point;
  };
}

Estimator byFit(double edges) {
  return [edges](Surface& surface, const Placed& example) {
    const Geometry& geometry = surface.geometry();
    return fittedMinimum(geometry, example, edges * geometry.meanEdge,
                         nearestPoint(surface.mesh(), example.truth));
  };
}

void study(const Family& family, const Array<int>& sizes, int count) {
  const struct {
    const char* name;
    Estimator find;
  } estimators[] = {
      {"paper, exact", byFields(Method::kPaper, Solver::kExact)},
      {"karcher, fast", byFields(Method::kKarcher, Solver::kFast)},
      {"karcher, exact", byFields(Method::kKarcher, Solver::kExact)},
      {"mesh, fit of .3 h", byFit(0.3)},
      {"mesh, fit of 1 h", byFit(1)},
      {"mesh, fit of 2 h", byFit(2)},
  };
  constexpr int kEstimators = std::size(estimators);
  const Array<Case> cases = chooseCases(family, count);
  double coarser[kEstimators] = {};
  double coarserEdge = 0;
  for (const int triangles : sizes) {
    Surface surface(importMesh(family.mesh(triangles)).mesh);
    const double edge = surface.geometry().meanEdge;
    double squares[kEstimators] = {};
    for (const Case& example : cases) {
      const Placed here = placed(family, surface, example);
      for (int k = 0; k < kEstimators; ++k) {
        const SurfacePoint found = estimators[k].find(surface, here);
        const Vec3 at = family.surface.project(position(surface.mesh(), found));
        squares[k] += (at - here.truth).squaredNorm() / count;
      }
    }
    std::printf("| %s | %d ", family.name.c_str(), surface.mesh().faceCount());
    for (int k = 0; k < kEstimators; ++k) {
      const double error = std::sqrt(squares[k]);
      std::printf("| %.2e ", error / edge);
      if (coarser[k] > 0) {
        std::printf("(%.1f) ", std::log(coarser[k] / error) / std::log(coarserEdge / edge));
      }
      coarser[k] = error;
    }
    std::printf("|\n");
    std::fflush(stdout);
    coarserEdge = edge;
  }
}

void studyAll(const Array<int>& sizes, int count, const std::string& part) {
  std::printf(
      "%d random cases of %d points (seed %d): root of the mean square distance from the true "
      "center, in mean edges h (order in h)\n\n"
      "| mesh | triangles | paper, exact | karcher, fast | karcher, exact | mesh: fit of .3 h | "
      "1 h | 2 h |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      count, kPoints, static_cast<int>(kSeed));
  for (const Family& family : families()) {
    if (family.name.find(part) != std::string::npos) study(family, sizes, count);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::Array<int> sizes{5'000, 20'000, 80'000};
    int cases = 12;
    std::string part;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--cases" && i + 1 < argc) {
        cases = std::stoi(argv[++i]);
      } else if (word == "--sizes" && i + 1 < argc) {
        sizes.clear();
        for (const char* at = argv[++i]; *at != '\0'; ++at) {
          char* end = nullptr;
          sizes.push_back(static_cast<int>(std::strtol(at, &end, 10)));
          if (*end == '\0') break;
          at = end;
        }
      } else {
        part = word;
      }
    }
    karcher::studyAll(sizes, cases, part);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

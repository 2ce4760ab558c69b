#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "bench_support.h"
#include "generators/gallery.h"
#include "generators/renumbered.h"
#include "mesh/error.h"
#include "rcm/exact_minimum.h"
#include "rcm/mean.h"

/// The worth of `converged` for a center of mass, on the gallery of meshes that try solvers
/// (generators/gallery.h), or on meshes of files. Points and weights are random. In every other
/// case the points lie within a tenth of the diagonal, and in two of four at vertices. For each
/// mesh:
///
/// - the statuses of the searches;
/// - the converged centers that are no minimum: at one of 97 points on a circle of .3 mean edges
///   about the center, the energy by exact distances is lower by more than 1e-3 square mean edges.
///   Also the greatest such difference. Both without the check by exact distances
///   (MeanOptions::isChecked) and with it;
/// - the centers that move by more than 1e-9 of the diagonal under rotations of the mesh, about its
///   middle and away from it, and under scale by a power of two. Those whose two energies differ by
///   less than 1e-6 are ties, which have their own count. Also the greatest distance without ties,
///   and the same for another order of vertices and faces;
/// - milliseconds a center, without and with kept fields.
///
///   centers_study [--cases N] [--solver exact] [--list] [PART_OF_A_NAME | MESH.obj ...]
///
/// --list prints each moved center that is no tie to the error output: the case, the
/// transformation, the distance, both statuses, and the relative difference of the energies.
namespace karcher {
namespace {

constexpr uint64_t kSeed = 29;
constexpr int kPoints = 4;
constexpr int kOnCircle = 97;
constexpr double kMoved = 1e-9;
constexpr double kTie = 1e-6;

struct Options {
  int cases = 8;
  Solver solver = Solver::kFast;
  bool isListed = false;
};

struct Lower {
  int count = 0;
  double worst = 0;  ///< square mean edges

  void take(double lower) {
    count += lower > kLowerBy ? 1 : 0;
    worst = std::max(worst, lower);
  }
  void take(const Lower& other) {
    count += other.count;
    worst = std::max(worst, other.worst);
  }
};

/// The centers that a change moved although it should not.
struct Moved {
  int count = 0;
  int ties = 0;
  double farthest = 0;  ///< the longest move, as a part of the diagonal

  void take(double distance, bool isTie) {
    if (distance <= kMoved) return;
    ties += isTie ? 1 : 0;
    count += isTie ? 0 : 1;
    if (!isTie) farthest = std::max(farthest, distance);
  }
  void take(const Moved& other) {
    count += other.count;
    ties += other.ties;
    farthest = std::max(farthest, other.farthest);
  }
};

struct Row {
  std::map<std::string, int> statuses;
  Lower unchecked;
  Lower checked;
  Moved moved;
  Moved renumbered;
  double uncheckedTime = 0;
  double time = 0;
};

/// The mesh rotated about the middle of its box, scaled, and moved by some diagonals.
TriangleMesh movedMesh(const TriangleMesh& mesh, const Vec3& by, double scale) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : mesh.positions) middle += p / mesh.vertexCount();
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  Array<Vec3> positions = mesh.positions;
  for (Vec3& p : positions) p = scale * p;
  if (scale == 1) {
    for (Vec3& p : positions) p = turn * (p - middle) + by;
  }
  return buildMesh(positions, mesh.faces);
}

/// The point, by the index of its vertex if it lies at one.
SurfacePoint byNumber(const TriangleMesh& mesh, const SurfacePoint& point) {
  const PointLocation location = locate(mesh, point);
  return location.simplex == Simplex::kVertex ? vertexPoint(mesh, location.vertex) : point;
}

SurfacePoint atNearestCorner(const TriangleMesh& mesh, const SurfacePoint& point) {
  int corner = 0;
  point.bary.maxCoeff(&corner);
  return vertexPoint(mesh, mesh.corner(point.face, corner));
}

Array<SurfacePoint> randomPoints(const TriangleMesh& mesh, double diagonal, bool isNear,
                                 Random& random) {
  Array<SurfacePoint> points{randomPoint(mesh, random)};
  const Vec3 first = position(mesh, points[0]);
  for (int tries = 0; points.count() < kPoints; ++tries) {
    const SurfacePoint point = randomPoint(mesh, random);
    const bool fits = (position(mesh, point) - first).norm() <= diagonal / 10;
    if (!isNear || fits || tries > 10'000) points.push_back(point);
  }
  return points;
}

/// The amount by which the lowest point on the circle is lower than the center, in square mean
/// edges. Its distances have no aim, and so differ from those of the search.
double lowerOnCircle(const Geometry& geometry, const Array<SurfacePoint>& points,
                     const Array<double>& weights, const SurfacePoint& center) {
  const double radius = kCheckedRadius * geometry.meanEdge;
  ExactEnergy energy(geometry, points, weights);
  energy.guesses.assign(kPoints, 1e3 * geometry.diagonal);
  Array<SurfacePoint> places{center};
  for (const SurfacePoint& place : circleAround(geometry, center, radius, kOnCircle)) {
    places.push_back(place);
  }
  const Array<double> values = energy.at(center, radius, places);
  const double least = *std::min_element(values.begin() + 1, values.end());
  return std::max(0.0, values[0] - least) / square(geometry.meanEdge);
}

Row measure(const TriangleMesh& mesh, const Options& options) {
  Surface surface(mesh);
  const Geometry& geometry = surface.geometry();
  Surface turned(movedMesh(mesh, Vec3::Zero(), 1));
  Surface away(movedMesh(mesh, 10 * geometry.diagonal * Vec3(0.6, -0.5, 0.62), 1));
  Surface scaled(movedMesh(mesh, Vec3::Zero(), 8));
  const Renumbered order = renumbered(mesh, kSeed);
  Surface reordered(order.mesh);
  MeanOptions mean;
  mean.field.solver = options.solver;
  mean.normalize = true;
  prepareFields(surface, mean.field);
  Random random(kSeed);
  Row row;
  for (int i = 0; i < options.cases; ++i) {
    Array<SurfacePoint> points = randomPoints(mesh, geometry.diagonal, i % 2 == 1, random);
    if (i % 4 > 1) {
      for (SurfacePoint& point : points) point = atNearestCorner(mesh, point);
    }
    Array<double> weights;
    for (int k = 0; k < kPoints; ++k) weights.push_back(random.uniform(0.1, 1));
    double sum = 0;
    for (const double weight : weights) sum += weight;
    for (double& weight : weights) weight /= sum;
    Mean center;
    try {
      row.uncheckedTime += processorTimed([&] {
        mean.isChecked = false;
        center = centerOfMass(surface, points, weights, mean);
      });
      if (center.status == Status::kConverged) {
        row.unchecked.take(lowerOnCircle(geometry, points, weights, center.point));
      }
      row.time += processorTimed([&] {
        mean.isChecked = true;
        center = centerOfMass(surface, points, weights, mean);
      });
    } catch (const Error& error) {
      ++row.statuses[error.code() == ErrorCode::kUnreachable ? "apart" : error.what()];
      continue;
    }
    ++row.statuses[statusName(center.status)];
    if (center.status != Status::kConverged) continue;
    row.checked.take(lowerOnCircle(geometry, points, weights, center.point));
    ExactEnergy energy(geometry, points, weights);
    const double here = energy.at(center.point, 0, {center.point})[0];
    const auto compare = [&](const char* by, const SurfacePoint& point, Status status,
                             Moved& moved) {
      const double distance =
          (position(mesh, point) - position(mesh, center.point)).norm() / geometry.diagonal;
      const double value = energy.at(point, 0, {point})[0];
      const bool isTie = status == Status::kConverged && std::abs(value - here) < kTie * here;
      moved.take(distance, isTie);
      if (!options.isListed || distance <= kMoved || isTie) return;
      std::fprintf(stderr, "case %d, %s: %.1e of the diagonal, %.2f edges, %s, energy %+.1e\n", i,
                   by, distance, distance * geometry.diagonal / geometry.meanEdge,
                   statusName(status), value / here - 1);
    };
    const auto compareMoved = [&](const char* by, Surface& other) {
      const Mean there = centerOfMass(other, points, weights, mean);
      compare(by, there.point, there.status, row.moved);
    };
    compareMoved("turned", turned);
    compareMoved("turned and away", away);
    compareMoved("scaled", scaled);
    Array<SurfacePoint> newPoints;
    for (const SurfacePoint& point : points) {
      newPoints.push_back(byNumber(reordered.mesh(), order.at(point)));
    }
    const Mean there = centerOfMass(reordered, newPoints, weights, mean);
    compare("renumbered", order.before(there.point), there.status, row.renumbered);
  }
  row.time /= options.cases;
  row.uncheckedTime /= options.cases;
  return row;
}

void print(const std::string& name, const TriangleMesh& mesh, const Options& options, Row& total) {
  std::printf("| %s | %d | ", name.c_str(), mesh.faceCount());
  std::fflush(stdout);
  try {
    const Row row = measure(mesh, options);
    for (const auto& [status, count] : row.statuses) {
      std::printf("%d %s ", count, status.c_str());
      total.statuses[status] += count;
    }
    std::printf("| %d | %.1e | %d | %.1e | %d | %d | %.0e | %d | %d | %.0e | %.1f | %.1f |\n",
                row.unchecked.count, row.unchecked.worst, row.checked.count, row.checked.worst,
                row.moved.count, row.moved.ties, row.moved.farthest, row.renumbered.count,
                row.renumbered.ties, row.renumbered.farthest, row.uncheckedTime, row.time);
    total.unchecked.take(row.unchecked);
    total.checked.take(row.checked);
    total.moved.take(row.moved);
    total.renumbered.take(row.renumbered);
  } catch (const std::exception& error) {
    std::printf("%s |\n", error.what());
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::Options options;
    karcher::Array<std::string> names;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--cases" && i + 1 < argc) {
        options.cases = std::stoi(argv[++i]);
      } else if (word == "--solver" && i + 1 < argc) {
        options.solver =
            std::string(argv[++i]) == "exact" ? karcher::Solver::kExact : karcher::Solver::kFast;
      } else if (word == "--list") {
        options.isListed = true;
      } else {
        names.push_back(word);
      }
    }
    std::printf("%d centers a mesh of %d points, seed %d\n\n", options.cases, karcher::kPoints,
                static_cast<int>(karcher::kSeed));
    std::printf(
        "| mesh | triangles | ended | unchecked: no minimum | lower by, h2 | checked: no minimum | "
        "lower by, h2 | moved | ties | farthest | renumbered: moved | ties | farthest | "
        "unchecked: ms | checked: ms |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- "
        "|\n");
    karcher::Row total;
    karcher::forEachMesh(
        names, [&](const std::string& name, const karcher::TriangleMesh& mesh, bool /*isFlat*/) {
          karcher::print(name, mesh, options, total);
        });
    std::printf("\nin all:");
    for (const auto& [status, count] : total.statuses) {
      std::printf(" %d %s,", count, status.c_str());
    }
    std::printf(" no minimum: unchecked %d (lower by %.1e h2 at most), checked %d (%.1e h2);",
                total.unchecked.count, total.unchecked.worst, total.checked.count,
                total.checked.worst);
    std::printf(" moved %d, ties %d, farthest %.0e; renumbered: moved %d, ties %d, farthest %.0e\n",
                total.moved.count, total.moved.ties, total.moved.farthest, total.renumbered.count,
                total.renumbered.ties, total.renumbered.farthest);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

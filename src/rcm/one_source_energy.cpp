#include "rcm/one_source_energy.h"

#include <algorithm>

#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

bool isBefore(const SurfacePoint& a, const SurfacePoint& b) {
  if (a.face != b.face) return a.face < b.face;
  return std::lexicographical_compare(a.bary.data(), a.bary.data() + 3, b.bary.data(),
                                      b.bary.data() + 3);
}

/// Moves a place inwards by more than rounding if it lies on the boundary of its face, since log
/// vectors need a start inside a face.
SurfacePoint movedInside(const SurfacePoint& place) {
  if (place.bary.minCoeff() > kChainRounding) return place;
  return {place.face, (1 - 3 * kChainRounding) * place.bary + Vec3::Constant(kChainRounding)};
}

/// The log vector of a point, interpolated between the corners of its face; exact on a plane.
Vec2 logOf(const TriangleMesh& mesh, const SurfacePoint& point, DistanceSolver& solver,
           SourceVectors& vectors) {
  Vec2 log = Vec2::Zero();
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) continue;
    log += point.bary[k] * vectors.at(solver, mesh.corner(point.face, k));
  }
  return log;
}

/// The squared distance of a point from the source. Each corner of the point's face sees the source
/// at a position in the plane of the face. If these positions differ, as across the cut locus, the
/// nearest position counts. Else the result blends the squared distances from the three positions.
double squaredDistanceOf(const Geometry& geometry, const SurfacePoint& point,
                         const DistanceSolver& solver) {
  const Vec2 place = pointInFace(geometry, point);
  double blended = 0;
  double least = kInfinity;
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) continue;
    const int h = 3 * point.face + k;
    const Vec2 toSource = solver.logVector(geometry.mesh->tail(h)) / -2;
    const Vec2 toPoint = place - cornerInFace(geometry, point.face, k);
    const double squared = (toPoint - rotate(geometry.vertexToFace[h], toSource)).squaredNorm();
    blended += point.bary[k] * squared;
    least = std::min(least, squared);
    most = std::max(most, squared);
  }
  constexpr double kApart = 0.5;
  return std::sqrt(most) - std::sqrt(least) > kApart * geometry.meanEdge ? least : blended;
}

/// Calls visit(h) for the three half-edges of each face that contains a point.
template <class Visit>
void forEachCorner(const WeightedPoints& points, const Visit& visit) {
  int last = -1;
  for (const SurfacePoint& point : points.points) {
    if (point.face == last) continue;
    last = point.face;
    for (int h = 3 * last; h < 3 * last + 3; ++h) visit(h);
  }
}

}  // namespace

WeightedPoints mergedPoints(const Array<SurfacePoint>& points, const Array<double>& weights) {
  WeightedPoints merged;
  const auto isFirst = [&](int a, int b) {
    if (isBefore(points[a], points[b])) return true;
    return !isBefore(points[b], points[a]) && weights[a] < weights[b];
  };
  for (const int i : sortedNumbers(points.count(), isFirst)) {
    if (weights[i] == 0) continue;
    if (!merged.points.empty() && !isBefore(merged.points.back(), points[i])) {
      merged.weights.back() += weights[i];
    } else {
      merged.points.push_back(points[i]);
      merged.weights.push_back(weights[i]);
    }
  }
  return merged;
}

OneSourceEnergy::OneSourceEnergy(const Geometry& geometry, const WeightedPoints& points,
                                 DistanceSolver& solver)
    : geometry_(geometry), points_(points), solver_(solver), vectors_(geometry) {}

EnergyAt OneSourceEnergy::at(const SurfacePoint& place) {
  const TriangleMesh& mesh = *geometry_.mesh;
  const SurfacePoint source = movedInside(place);
  solver_.setSource(source);
  forEachCorner(points_, [&](int h) { solver_.growTo(mesh.tail(h)); });
  vectors_.setSource(source);
  ++solved_;
  EnergyAt result;
  for (int i = 0; i < points_.points.count(); ++i) {
    const SurfacePoint& point = points_.points[i];
    const double squared = squaredDistanceOf(geometry_, point, solver_);
    const Vec2 log = logOf(mesh, point, solver_, vectors_);
    const double length = log.norm();
    result.energy += points_.weights[i] * squared;
    if (length > 0) result.step += points_.weights[i] * std::sqrt(squared) / length * log;
  }
  return result;
}

ExactOneSourceEnergy::ExactOneSourceEnergy(const Geometry& geometry, const WeightedPoints& points)
    : geometry_(geometry), points_(points), solver_(geometry) {
  Array<int> faces;
  for (const SurfacePoint& point : points.points) {
    if (faces.empty() || faces.back() != point.face) faces.push_back(point.face);
  }
  solver_.keepImagesIn(std::move(faces));
  ways_.resize(points.points.size());
}

EnergyAt ExactOneSourceEnergy::at(const SurfacePoint& place) {
  EnergyAt result;
  result.energy = energyAt(place);
  directions_.assign(geometry_.mesh->positions.size(), Vec2::Zero());
  for (int i = 0; i < points_.points.count(); ++i) {
    const Way& way = ways_[i];
    if (!(way.length > 0)) continue;
    const Vec2 direction =
        way.pseudoSource >= 0
            ? directionTo(way.pseudoSource)
            : directionBefore(traceStraightest(geometry_, points_.points[i], way.toSource));
    result.step += points_.weights[i] * way.length * direction;
  }
  return result;
}

double ExactOneSourceEnergy::energyAt(const SurfacePoint& place) {
  grow(movedInside(place));
  measure();
  ++solved_;
  double energy = 0;
  for (int i = 0; i < points_.points.count(); ++i) {
    energy += points_.weights[i] * square(ways_[i].length);
  }
  return energy;
}

/// The direction in which the shortest path to a vertex leaves the source.
Vec2 ExactOneSourceEnergy::directionTo(int vertex) {
  // The loop ends: each vertex on the way is nearer to the source than the previous one.
  while (solver_.arrival(vertex).pseudoSource >= 0) vertex = solver_.arrival(vertex).pseudoSource;
  Vec2& direction = directions_[vertex];
  if (direction == Vec2::Zero()) {
    direction = directionBefore(
        traceFromVertex(geometry_, vertex, solver_.direction(vertex), solver_.distance(vertex)));
  }
  return direction;
}

/// The direction in which a path leaves the source. `back` is the path's trace from its end to the
/// source.
Vec2 ExactOneSourceEnergy::directionBefore(const StraightestPath& back) const {
  const int face = solver_.source().face;
  const Array<SurfacePoint>& points = back.path.points;
  if (points.back().face == face) return -back.direction;
  // Rounding may take the path past the source.
  for (int i = points.count() - 2; i > 0; --i) {
    if (points[i].face != face || points[i - 1].face != face) continue;
    return stepInFace(geometry_, face, points[i], points[i - 1]).normalized();
  }
  return Vec2::Zero();
}

/// Grows the solver until no point can have a shorter path. All paths to a point pass through its
/// face.
void ExactOneSourceEnergy::grow(const SurfacePoint& place) {
  const TriangleMesh& mesh = *geometry_.mesh;
  solver_.setSource(place);
  double radius = geometry_.meanEdge;
  for (const SurfacePoint& point : points_.points) {
    radius = std::max(radius, (position(mesh, point) - position(mesh, place)).norm());
  }
  // The loop ends: growth never increases the distance of a corner, and an increasing radius
  // finally reaches the whole mesh.
  for (;;) {
    solver_.grow(radius);
    if (solver_.reached() == kInfinity) break;
    double needed = 0;
    forEachCorner(points_, [&](int h) {
      needed = std::max(needed, solver_.distance(mesh.tail(h)) + geometry_.edgeLength[h]);
    });
    if (needed <= radius) break;
    radius = needed < kInfinity ? needed : 2 * radius;
  }
}

/// Finds the shortest way to each point: straight from an image of the source in the point's face,
/// or over one of the face's corners.
void ExactOneSourceEnergy::measure() {
  const TriangleMesh& mesh = *geometry_.mesh;
  const auto take = [&](int i, const Way& way) {
    if (way.length < ways_[i].length) ways_[i] = way;
  };
  for (int i = 0; i < points_.points.count(); ++i) {
    const SurfacePoint& point = points_.points[i];
    const Vec2 inside = pointInFace(geometry_, point);
    ways_[i] = {};
    for (int k = 0; k < 3; ++k) {
      const Vec2 way = cornerInFace(geometry_, point.face, k) - inside;
      const int corner = mesh.corner(point.face, k);
      take(i, {solver_.distance(corner) + way.norm(), way, corner});
    }
  }
  for (const SourceImage& image : solver_.images()) {
    const auto first =
        std::lower_bound(points_.points.begin(), points_.points.end(), image.face,
                         [](const SurfacePoint& point, int face) { return point.face < face; });
    for (int i = static_cast<int>(first - points_.points.begin());
         i < points_.points.count() && points_.points[i].face == image.face; ++i) {
      const Vec2 inside = pointInFace(geometry_, points_.points[i]);
      take(i, {lengthFrom(image, inside), image.source - inside, image.pseudoSource});
    }
  }
}

}  // namespace karcher

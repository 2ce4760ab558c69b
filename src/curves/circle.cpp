#include "curves/circle.h"

#include <limits>
#include <string>

#include "curves/curve.h"
#include "distance/exact_lengths.h"
#include "distance/window_distance.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

constexpr int kFewestArcs = 3;
/// The number of arcs in a full turn before the first division, if the options set no number. It is
/// also the default number of an ellipse's arcs.
constexpr int kFirstArcs = 7;
constexpr int kMostCuts = 4;
constexpr int kMostParts = 4;  ///< the largest number of parts into which a round divides an arc
constexpr int kFewestSamples = 5;

void checkRadiusIsPositive(double radius) {
  if (radius > 0 && std::isfinite(radius)) return;
  throw Error(ErrorCode::kBadArgument,
              "the radius must be a positive number, not " + inSentence(radius));
}

void checkOptions(const CircleOptions& options) {
  if (options.arcs && (*options.arcs < kFewestArcs || *options.arcs > kMostArcs)) {
    throw Error(ErrorCode::kBadArgument,
                "a circle has 3 to 64 arcs, not " + std::to_string(*options.arcs));
  }
  if (options.samples < 2 || options.samples > kMostSamples) {
    throw Error(ErrorCode::kBadArgument, "an arc can have 2 to " + std::to_string(kMostSamples) +
                                             " samples, not " + std::to_string(options.samples));
  }
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw Error(ErrorCode::kBadArgument, "a circle's tolerance must be a positive number, not " +
                                             inSentence(options.tolerance));
  }
  checkFieldOptions(options.field);
}

/// Straightest geodesics from the circle's center.
class Center {
 public:
  Center(const Geometry& geometry, const SurfacePoint& point)
      : geometry_(geometry), point_(point), location_(locate(*geometry.mesh, point)) {
    if (location_.simplex == Simplex::kVertex) total_ = geometry.totalAngle[location_.vertex];
  }

  /// Throws Error kBoundary if the center lies on the boundary, so that no circle goes around it.
  void checkIsInside() const {
    const bool atVertex = location_.simplex == Simplex::kVertex;
    const bool atEdge = location_.simplex == Simplex::kEdge;
    if (atVertex ? !geometry_.mesh->onBoundary[location_.vertex]
                 : !atEdge || geometry_.mesh->twin[location_.halfedge] >= 0) {
      return;
    }
    throw Error(ErrorCode::kBoundary, std::string("the center is ") +
                                          (atVertex ? "a vertex" : "on an edge") +
                                          " of the boundary: no circle or ellipse goes around it");
  }

  double totalAngle() const { return total_; }

  /// Returns an angle for `trace`: the direction of a vector in the frame of the center's face.
  double directionOf(const Vec2& vector) const {
    if (location_.simplex != Simplex::kVertex) return angleOf(vector);
    int h = 3 * point_.face;
    while (geometry_.mesh->tail(h) != location_.vertex) ++h;
    return directionAtTail(geometry_, h, vector);
  }

  StraightestPath trace(double direction, double length) const {
    return location_.simplex == Simplex::kVertex
               ? traceFromVertex(geometry_, location_.vertex, direction, length)
               : traceStraightest(geometry_, point_, length * unitVector(direction));
  }

 private:
  const Geometry& geometry_;
  SurfacePoint point_;
  PointLocation location_;
  double total_ = 2 * kPi;
};

/// Throws Error kBadArgument if the radius is lost in rounding at the center.
void checkRadiusIsTold(const Geometry& geometry, const SurfacePoint& center, double radius) {
  const TriangleMesh& mesh = *geometry.mesh;
  const PointLocation location = locate(mesh, center);
  double longest = 0;
  const auto take = [&](int face) {
    for (int k = 0; k < 3; ++k) longest = std::max(longest, geometry.edgeLength[3 * face + k]);
  };
  take(center.face);
  if (location.simplex == Simplex::kVertex) {
    for (const int h : outgoingHalfedges(mesh, location.vertex)) take(faceOf(h));
  } else if (location.simplex == Simplex::kEdge && mesh.twin[location.halfedge] >= 0) {
    take(faceOf(mesh.twin[location.halfedge]));
  }
  // Shorter lengths are lost in the rounding of computations with edges and coordinates of this
  // size.
  const double least =
      kChainRounding * std::max(longest, position(mesh, center).cwiseAbs().maxCoeff());
  if (radius >= least) return;
  throw Error(ErrorCode::kBadArgument, "the radius " + inSentence(radius) +
                                           " is lost in rounding: around this "
                                           "center it must be at least " +
                                           inSentence(least));
}

void checkRadius(const TriangleMesh& mesh, const WindowDistance& distance, double radius) {
  double farthest = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double d = distance.distance(v);
    if (d != kInfinity) farthest = std::max(farthest, d);
  }
  if (farthest >= radius) return;
  throw Error(ErrorCode::kRadiusTooLarge,
              "the radius " + inSentence(radius) +
                  " goes beyond the farthest vertex of the component, at " + inSentence(farthest) +
                  " from the center");
}

/// The distance of a point from the center, interpolated from the squared distances and the log
/// vectors at the corners of the point's face.
double distanceAt(const Geometry& geometry, const WindowDistance& distance,
                  const SurfacePoint& point) {
  const Vec2 x = pointInFace(geometry, point);
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * point.face + k;
    const int vertex = geometry.mesh->tail(h);
    const double d = distance.distance(vertex);
    const Vec2 toSource = unitVector(geometry.angleScale[vertex] * distance.direction(vertex));
    const Vec2 gradient = rotate(geometry.vertexToFace[h], -2 * d * toSource);
    const Vec2 step = x - cornerInFace(geometry, point.face, k);
    squared += point.bary[k] * (d * d + gradient.dot(step) / 2);
  }
  return std::sqrt(std::max(squared, 0.0));
}

/// The polar coordinates of a control point about the center.
struct ArcPoint {
  double direction = 0;
  double distance = 0;
};

/// The start and the middle control point of an arc. Its end is the start of the next arc.
struct Arc {
  ArcPoint start;
  ArcPoint middle;
  double middleWeight = 0;
};

/// The options of the closed NURBS curve of degree 2 that consists of the arcs. Its doubled knots
/// make each arc a rational quadratic Bezier curve.
CurveOptions optionsOfArcs(const Array<Arc>& arcs, const CircleOptions& options) {
  CurveOptions result{
      {CurveKind::kBSpline, true, 2, KnotRule::kOwn}, options.samples, options.field};
  result.shape.knots.push_back(0);
  for (int j = 0; j < arcs.count(); ++j) {
    result.shape.knots.insert(result.shape.knots.end(), 2, j + 1);
    result.shape.weights.insert(result.shape.weights.end(), {1, arcs[j].middleWeight});
  }
  result.levels = options.levels;
  return result;
}

/// Whether the disk around the center contains no other vertex, so that the surface there is a
/// plane, or a cone about a vertex. The distances must extend beyond the disk.
bool isPlain(const TriangleMesh& mesh, const WindowDistance& distance, double radius) {
  const PointLocation location = locate(mesh, distance.source());
  const int own = location.simplex == Simplex::kVertex ? location.vertex : -1;
  bool plain = true;
  distance.forEachMet([&](int v) { plain = plain && (v == own || distance.distance(v) > radius); });
  return plain;
}

/// The samples of an arc in a disk without other vertices. Such a disk unrolls onto the plane, so
/// that the arc's centers of mass are those of the unrolled control points.
Array<CurveSample> planeArc(const Center& from, const ArcPoint (&control)[3],
                            const SurfacePoint& start, const SurfacePoint& end, double middleWeight,
                            int count) {
  const auto inPlane = [&](const ArcPoint& point) -> Vec2 {
    return point.distance * unitVector(point.direction - control[0].direction);
  };
  const Vec2 places[3] = {inPlane(control[0]), inPlane(control[1]), inPlane(control[2])};
  Array<CurveSample> samples;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    if (i == 0 || i == count - 1) {
      samples.push_back({t, i == 0 ? start : end});
      continue;
    }
    const double weights[3] = {(1 - t) * (1 - t), 2 * t * (1 - t) * middleWeight, t * t};
    const Vec2 place = (weights[0] * places[0] + weights[1] * places[1] + weights[2] * places[2]) /
                       (weights[0] + weights[1] + weights[2]);
    const StraightestPath path = from.trace(control[0].direction + angleOf(place), place.norm());
    samples.push_back({t, path.path.end()});
  }
  return samples;
}

/// Traces the arcs. Throws Error kRadiusTooLarge if no vertex is as far as `radius` from the
/// center, and kBoundary if a geodesic to a control point meets the boundary.
GeodesicCircle traceArcs(Surface& surface, const SurfacePoint& center, double radius,
                         const Array<Arc>& arcs, const CircleOptions& options) {
  const Geometry& geometry = surface.geometry();
  const Center from(geometry, center);
  Array<ArcPoint> arcPoints;
  for (const Arc& arc : arcs) arcPoints.insert(arcPoints.end(), {arc.start, arc.middle});
  double farthest = 0;
  for (const ArcPoint& point : arcPoints) farthest = std::max(farthest, point.distance);
  WindowDistance distance(geometry);
  distance.setSource(center);
  distance.grow(farthest + geometry.meanEdge);
  checkRadius(surface.mesh(), distance, radius);

  Array<SurfacePoint> points;
  for (int i = 0; i < arcPoints.count(); ++i) {
    const double length = arcPoints[i].distance;
    const StraightestPath path = from.trace(arcPoints[i].direction, length);
    if (path.stop != TraceStop::kComplete) {
      throw Error(ErrorCode::kBoundary,
                  "the geodesic to arc " + std::to_string(i / 2) + " meets the boundary");
    }
    points.push_back(path.path.end());
  }
  // A disk without other vertices may overlap itself, for instance around a prism. Few faces, which
  // may be large, cover it.
  const bool plain = isPlain(surface.mesh(), distance, farthest);
  const Array<double> lengths =
      plain ? exactLengths(geometry, center, points, farthest) : Array<double>();
  const double tolerance = (plain ? kChainRounding : 0.05) * geometry.meanEdge;
  Array<uint8_t> shortest;
  for (int i = 0; i < points.count(); ++i) {
    const double length = plain ? lengths[i] : distanceAt(geometry, distance, points[i]);
    shortest.push_back(length > arcPoints[i].distance - tolerance);
  }
  GeodesicCircle circle;
  for (int j = 0; j < arcs.count(); ++j) {
    if (!shortest[2 * j] || !shortest[2 * j + 1] || !shortest[(2 * j + 2) % points.count()]) {
      circle.notShortest.push_back(j);
    }
  }

  if (plain) {
    for (int j = 0; j < arcs.count(); ++j) {
      const int last = (2 * j + 2) % points.count();
      ArcPoint end = arcPoints[last];
      if (last == 0) end.direction += from.totalAngle();
      circle.samples.push_back(planeArc(from, {arcPoints[2 * j], arcPoints[2 * j + 1], end},
                                        points[2 * j], points[last], arcs[j].middleWeight,
                                        options.samples));
      circle.bridges.emplace_back();
      circle.paths.push_back(joinSamples(surface, circle.samples[j]));
    }
    return circle;
  }

  const Curve curve(surface, optionsOfArcs(arcs, options), points);
  circle.levels = curve.levels();
  for (int j = 0; j < arcs.count(); ++j) {
    circle.samples.push_back(curve.samples(j));
    circle.bridges.push_back(curve.bridges(j));
    circle.paths.push_back(curve.path(j));
  }
  return circle;
}

/// The arcs of a circle between consecutive directions from its center. The directions ascend from
/// 0 to the total angle.
Array<Arc> arcsBetween(const Array<double>& directions, double radius) {
  Array<Arc> arcs;
  for (int j = 0; j + 1 < directions.count(); ++j) {
    const double halfAngle = (directions[j + 1] - directions[j]) / 2;
    const double weight = std::cos(halfAngle);
    arcs.push_back({{directions[j], radius}, {directions[j] + halfAngle, radius / weight}, weight});
  }
  return arcs;
}

/// For each arc, the largest difference between a sample's distance from the center and the radius,
/// relative to the radius.
Array<double> deviationsOf(const Geometry& geometry, const SurfacePoint& center, double radius,
                           const GeodesicCircle& circle) {
  Array<SurfacePoint> points;
  for (const Array<CurveSample>& arc : circle.samples) {
    for (const CurveSample& sample : arc) points.push_back(sample.point);
  }
  const double likely = radius + geometry.meanEdge;
  const Array<double> lengths = exactLengths(geometry, center, points, likely);
  Array<double> deviations;
  int i = 0;
  for (const Array<CurveSample>& arc : circle.samples) {
    deviations.push_back(0);
    for (int k = 0; k < arc.count(); ++k, ++i) {
      deviations.back() = std::max(deviations.back(), std::abs(lengths[i] / radius - 1));
    }
  }
  return deviations;
}

/// The number of parts of each arc after a division. Arcs with larger deviations are divided first,
/// until the limit on the number of arcs is reached.
Array<int> partsOfArcs(const Array<double>& deviations, double tolerance) {
  const int count = deviations.count();
  Array<int> parts;
  parts.assign(deviations.size(), 1);
  const Array<int> order =
      sortedNumbers(count, [&](int a, int b) { return deviations[a] > deviations[b]; });
  int room = kMostFittingArcs - count;
  for (const int j : order) {
    if (deviations[j] <= tolerance) break;
    const double wanted = std::ceil(std::sqrt(deviations[j] / tolerance));
    const int more = std::min(static_cast<int>(std::min<double>(wanted, kMostParts)) - 1, room);
    parts[j] += std::max(more, 0);
    room -= parts[j] - 1;
  }
  return parts;
}

Array<double> cutInto(const Array<int>& parts, const Array<double>& directions) {
  Array<double> result;
  for (int j = 0; j < parts.count(); ++j) {
    const double width = (directions[j + 1] - directions[j]) / parts[j];
    for (int k = 0; k < parts[j]; ++k) result.push_back(directions[j] + k * width);
  }
  result.push_back(directions.back());
  return result;
}

/// The number of samples of each arc. It is `samples` if the widest arc is a seventh of the turn,
/// and proportionally smaller if that arc is narrower. It is at least 5, or `samples` if that is
/// less.
int samplesOfArcs(const Array<double>& directions, int samples) {
  double widest = 0;
  for (int j = 0; j + 1 < directions.count(); ++j) {
    widest = std::max(widest, directions[j + 1] - directions[j]);
  }
  const double part = widest * kFirstArcs / directions.back();
  // Rounding must not add a sample.
  const double wanted = std::ceil((1 - kLocalRounding) * part * samples);
  return std::max(std::min(kFewestSamples, samples), static_cast<int>(wanted));
}

[[noreturn]] void throwTooFew(int count, const Center& from, const std::string& reason) {
  throw Error(ErrorCode::kBadArgument,
              std::to_string(count) + " arcs are too few around a center of " +
                  inSentence(from.totalAngle() / (2 * kPi)) + " full turns: " + reason);
}

}  // namespace

GeodesicCircle traceCircle(Surface& surface, const SurfacePoint& center, double radius,
                           const CircleOptions& options) {
  checkRadiusIsPositive(radius);
  checkOptions(options);
  const Center from(surface.geometry(), center);
  from.checkIsInside();
  checkRadiusIsTold(surface.geometry(), center, radius);
  const double turn = from.totalAngle();
  // Each arc must be narrower than pi, however large the total angle at a vertex is.
  const int fewest = static_cast<int>(turn / kPi) + 1;
  const int fitting =
      std::max(kFirstArcs, static_cast<int>(std::ceil(kFirstArcs * turn / (2 * kPi))));
  const int count = options.arcs.value_or(std::min(fitting, kMostFittingArcs));
  if (count < fewest || !(turn / (2 * count) < kPi / 2)) {
    throwTooFew(count, from, "the fewest are " + std::to_string(fewest));
  }
  Array<double> directions;
  for (int j = 0; j <= count; ++j) directions.push_back(j * turn / count);

  std::optional<GeodesicCircle> best;
  for (int cuts = 0;; ++cuts) {
    CircleOptions own = options;
    if (!options.arcs) own.samples = samplesOfArcs(directions, options.samples);
    GeodesicCircle circle =
        traceArcs(surface, center, radius, arcsBetween(directions, radius), own);
    const Array<double> deviations = deviationsOf(surface.geometry(), center, radius, circle);
    circle.deviation = *std::max_element(deviations.begin(), deviations.end());
    const bool isBest = !best || *circle.deviation < *best->deviation;
    if (options.arcs) return circle;
    const Array<int> parts = partsOfArcs(deviations, options.tolerance);
    if (isBest) best = std::move(circle);
    const Array<double> next = cutInto(parts, directions);
    if (cuts == kMostCuts || next.count() == directions.count()) return *std::move(best);
    directions = next;
  }
}

GeodesicCircle traceEllipse(Surface& surface, const SurfacePoint& center, double along,
                            double across, const Vec2& direction, const CircleOptions& options) {
  checkRadiusIsPositive(along);
  checkRadiusIsPositive(across);
  checkOptions(options);
  if (!direction.allFinite() || !(direction.norm() > 0)) {
    throw Error(ErrorCode::kBadArgument, "an ellipse's direction must be a vector that is not 0");
  }
  const Center from(surface.geometry(), center);
  from.checkIsInside();
  checkRadiusIsTold(surface.geometry(), center, std::min(along, across));
  const double begin = from.directionOf(direction);
  const int count = options.arcs.value_or(kFirstArcs);
  const double halfAngle = kPi / count;
  Array<ArcPoint> points;
  for (int i = 0; i < 2 * count; ++i) {
    const double reach = i % 2 == 0 ? 1 : 1 / std::cos(halfAngle);
    const Vec2 place =
        reach * Vec2(along * std::cos(i * halfAngle), across * std::sin(i * halfAngle));
    // The directions ascend, as `planeArc` needs: it takes the differences of them.
    double turned = angleOf(place);
    if (turned < 0) turned += 2 * kPi;
    // Around a vertex, the plane's angles are scaled to the vertex's total angle.
    const double angle = turned * from.totalAngle() / (2 * kPi);
    points.push_back({begin + angle, place.norm()});
  }
  Array<Arc> arcs;
  for (int j = 0; j < count; ++j) {
    const double end = j + 1 < count ? points[2 * j + 2].direction : begin + from.totalAngle();
    if (!(end - points[2 * j].direction < kPi)) {
      throwTooFew(count, from, "one would be wider than half a turn");
    }
    arcs.push_back({points[2 * j], points[2 * j + 1], std::cos(halfAngle)});
  }
  return traceArcs(surface, center, std::max(along, across), arcs, options);
}

}  // namespace karcher

#include "rcm/minimum_search.h"

#include <algorithm>
#include <utility>

#include "intrinsic/tangent.h"
#include "mesh/positions.h"
#include "rcm/center_search.h"
#include "rcm/deepest_zero.h"
#include "rcm/first_start.h"

namespace karcher {
namespace {

/// Whether a is the better mean: converged means come first, then lower energies.
bool better(const Mean& a, const Mean& b) {
  const bool aConverged = a.status == Status::kConverged;
  const bool bConverged = b.status == Status::kConverged;
  return aConverged != bConverged ? aConverged : a.energy < b.energy;
}

constexpr int kSpreadStarts = 32;

/// Whether two minima are different. Searches for one minimum from both sides of an edge may end
/// kNearEdge mean edges apart.
bool areApart(const Geometry& geometry, const SurfacePoint& a, const SurfacePoint& b) {
  const TriangleMesh& mesh = *geometry.mesh;
  return (position(mesh, a) - position(mesh, b)).norm() > kNearEdge * geometry.meanEdge;
}

/// The same start, in a face that does not depend on the numbering of faces: if the start lies on
/// an edge or at a vertex, this is the face into which K decreases.
SurfacePoint facedDownhill(FieldBlend& fields, Weights weights, const SurfacePoint& start) {
  const Geometry& geometry = fields.geometry();
  const TriangleMesh& mesh = *geometry.mesh;
  const PointLocation location = locate(mesh, start);
  if (location.simplex == Simplex::kVertex) {
    const Vec2 down = -fields.atVertex(location.vertex, weights);
    const double direction = directionAt(geometry, location.vertex, down);
    return edgePoint(cornerOfDirection(geometry, location.vertex, direction).halfedge, 0);
  }
  if (location.simplex == Simplex::kEdge) {
    const int h = location.halfedge;
    const int twin = mesh.twin[h];
    const SurfacePoint here = inFace(mesh, start, faceOf(h));
    const bool fallsOver = cross(halfedgeInFace(geometry, h), fields.at(here, weights)) > 0;
    return twin >= 0 && fallsOver ? inFace(mesh, start, faceOf(twin)) : here;
  }
  return start;
}

/// A sequence of searches. The center is the first search's result or, with `lowest`, the best
/// result of all.
class MinimumSearch {
 public:
  MinimumSearch(FieldBlend& fields, const Array<double>& weights, Method method)
      : fields_(fields), weights_(weights), method_(method) {}

  void from(const SurfacePoint& start, bool lowest) {
    const SearchEnd end = isZero(fields_, weights_, start) ? SearchEnd{start} : search(start);
    Mean found = withEnergy(fields_, weights_, end);
    const bool isFirst = !begun_;
    begun_ = true;
    if (isFirst || (lowest && better(found, best_))) std::swap(found, best_);
    if (isFirst || found.status != Status::kConverged) return;
    insertByEnergy(others_, {found.point, found.energy});
  }

  const Mean& best() const { return best_; }

  Mean result() {
    setOtherMinima(fields_.geometry(), others_, best_);
    return std::move(best_);
  }

 private:
  SearchEnd search(const SurfacePoint& start) {
    const bool goesDown = goesOnWhereIndefinite(method_);
    return findCenter(fields_, weights_, goesDown ? facedDownhill(fields_, weights_, start) : start,
                      method_);
  }

  FieldBlend& fields_;
  const Array<double>& weights_;
  Method method_;
  bool begun_ = false;
  Mean best_;
  Array<Minimum> others_;
};

/// Control points within this radius are starts. It is relative to the radius within which a lower
/// minimum may lie (LowerPlaces). In a test of 810 means of three to eight points on three meshes,
/// searches from all control points gave a lower mean in four cases. In eight cases they gave a
/// higher mean, since they did not start at the average of averages.
constexpr double kSearched = 2;

/// Searches from `start`, if any, and from the control points near which a lower minimum may be. It
/// searches from all control points if `all` is set, if there is no start, if the search from the
/// start failed, or if a weight is negative.
void searchFew(const TriangleMesh& mesh, const Array<SurfacePoint>& points,
               const Array<double>& weights, bool all, const std::optional<SurfacePoint>& start,
               MinimumSearch& minima) {
  LowerPlaces lower{Vec3::Zero(), kInfinity};
  if (start) {
    minima.from(*start, true);
    const Mean& found = minima.best();
    const bool isBounded = *std::min_element(weights.begin(), weights.end()) >= 0;
    if (!all && isBounded && found.status == Status::kConverged) {
      lower = lowerPlaces(mesh, points, weights, found.energy);
    }
  }
  for (const SurfacePoint& point : points) {
    const double apart = (position(mesh, point) - lower.middle).norm();
    if (apart <= kSearched * lower.radius) minima.from(point, true);
  }
}

}  // namespace

int firstLargest(const Array<double>& weights) {
  return static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

Mean withEnergy(FieldBlend& fields, const Array<double>& weights, const SearchEnd& center) {
  return {center.point,           center.status,
          center.iterations,      fields.energy(center.point, weights),
          Uniqueness::kNotLooked, {}};
}

void insertByEnergy(Array<Minimum>& minima, const Minimum& minimum) {
  int place = minima.count();
  while (place > 0 && minimum.energy < minima[place - 1].energy) --place;
  minima.insert(minima.begin() + place, minimum);
}

void setOtherMinima(const Geometry& geometry, const Array<Minimum>& minima, Mean& mean) {
  Array<Minimum> apart;
  for (const Minimum& minimum : minima) {
    bool isNew = areApart(geometry, minimum.point, mean.point);
    for (const Minimum& known : apart) {
      isNew = isNew && areApart(geometry, minimum.point, known.point);
    }
    if (isNew) apart.push_back(minimum);
  }
  mean.uniqueness = apart.empty() ? Uniqueness::kNotLooked : Uniqueness::kNotUnique;
  mean.otherMinima = std::move(apart);
}

Mean findMean(Surface& surface, FieldBlend& fields, const Array<double>& blendWeights,
              const Array<SurfacePoint>& points, const Array<double>& pointWeights,
              const MeanOptions& options, const SurfacePoint* shared) {
  MinimumSearch minima(fields, blendWeights, options.field.method);
  const bool lowest = !options.start;
  const bool goesDown = goesOnWhereIndefinite(options.field.method);
  if (options.start) {
    minima.from(*options.start, lowest);
  } else if (goesDown) {
    searchFew(surface.mesh(), points, pointWeights, options.looksForOthers,
              shared ? *shared : averageOfAverages(surface.geometry(), points, pointWeights),
              minima);
  } else if (!options.looksForOthers) {
    minima.from(points[firstLargest(pointWeights)], lowest);
  }
  if (options.looksForOthers) {
    const bool hasAll = lowest && goesDown;
    if (!hasAll) {
      for (const SurfacePoint& point : points) minima.from(point, lowest);
    }
    for (const SurfacePoint& place : spreadPoints(surface, points[0].face, kSpreadStarts)) {
      minima.from(place, lowest);
    }
  }
  return minima.result();
}

}  // namespace karcher

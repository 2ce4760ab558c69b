#include "fuzz/counted_sides.h"

#include <algorithm>
#include <stdexcept>

#include "intrinsic/strip_path.h"

namespace karcher {
namespace {

// Tolerances in the coordinates of a face, the second and the third weight: a point nearer to a
// side than the first lies on it, and a point nearer to a path than the second has no label.
constexpr double kOnSide = 1e-8;
constexpr double kTooNear = 1e-8;
constexpr int kTrials = 200;

Vec2 placeOf(const SurfacePoint& point) {
  Vec3 bary = point.bary;
  for (double& weight : bary) {
    if (weight < kOnSide) weight = 0;
  }
  bary /= bary.sum();
  return {bary[1], bary[2]};
}

Vec2 onSide(int k, double t) {
  const Vec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
  return (1 - t) * corners[k] + t * corners[(k + 1) % 3];
}

double distanceTo(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 way = b - a;
  const double squared = way.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(way) / squared, 0.0, 1.0) : 0;
  return (p - a - t * way).norm();
}

}  // namespace

CountedSides::CountedSides(const Geometry& geometry, std::span<const SurfacePath> paths,
                           Random& random)
    : mesh_(*geometry.mesh),
      paths_(static_cast<int>(paths.size())),
      pieces_(static_cast<size_t>(mesh_.faceCount())),
      runs_(static_cast<size_t>(mesh_.halfedgeCount())) {
  for (int i = 0; i < paths_; ++i) {
    const Array<SurfacePoint>& points = paths[static_cast<size_t>(i)].points;
    for (int k = 1; k < points.count(); ++k) {
      addPiece(commonFace(mesh_, points[k - 1], points[k]), i, points[k - 1], points[k]);
    }
  }
  placeMiddles(random);
  labels_.assign(static_cast<size_t>(mesh_.faceCount()), {});
  for (int first = 0; first < mesh_.faceCount(); ++first) {
    if (!labels_[first].empty()) continue;
    labels_[first].assign(static_cast<size_t>(paths_), 0);
    Array<int> faces{first};
    for (int i = 0; i < faces.count(); ++i) {
      const int f = faces[i];
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (mesh_.twin[h] < 0) continue;
        const int other = faceOf(mesh_.twin[h]);
        Array<int> label = change(h, random);
        for (int p = 0; p < paths_; ++p) label[p] += labels_[f][p];
        if (labels_[other].empty()) {
          labels_[other] = std::move(label);
          faces.push_back(other);
          continue;
        }
        for (int p = 0; p < paths_; ++p) label[p] -= labels_[other][p];
        const bool agree = std::all_of(label.begin(), label.end(), [](int d) { return d == 0; });
        if (!agree) defects_.push_back(std::move(label));
      }
    }
  }
}

void CountedSides::addPiece(int f, int path, const SurfacePoint& a, const SurfacePoint& b) {
  const Vec2 from = placeOf(inFace(mesh_, a, f));
  const Vec2 to = placeOf(inFace(mesh_, b, f));
  const Vec3 weights[] = {{1 - from.x() - from.y(), from.x(), from.y()},
                          {1 - to.x() - to.y(), to.x(), to.y()}};
  for (int k = 0; k < 3; ++k) {
    const int opposite = (k + 2) % 3;
    if (weights[0][opposite] > kOnSide || weights[1][opposite] > kOnSide) continue;
    const int h = 3 * f + k;
    double start = weights[0][(k + 1) % 3];
    double end = weights[1][(k + 1) % 3];
    const bool isOther = mesh_.twin[h] >= 0 && mesh_.twin[h] < h;
    if (isOther) {
      start = 1 - start;
      end = 1 - end;
    }
    runs_[isOther ? mesh_.twin[h] : h].push_back({path, start, end});
    return;
  }
  pieces_[f].push_back({path, from, to});
}

bool CountedSides::isFree(int f, const Vec2& place) const {
  return std::all_of(pieces_[f].begin(), pieces_[f].end(), [&](const Piece& piece) {
    return distanceTo(piece.from, piece.to, place) > kTooNear;
  });
}

void CountedSides::placeMiddles(Random& random) {
  for (int f = 0; f < mesh_.faceCount(); ++f) {
    Vec2 place(1 / 3.0, 1 / 3.0);
    for (int trial = 0; !isFree(f, place); ++trial) {
      if (trial == kTrials) throw std::runtime_error("no place in a face is free of paths");
      Vec3 bary(random.uniform(), random.uniform(), random.uniform());
      bary /= bary.sum();
      place = {bary[1], bary[2]};
    }
    middle_.push_back(place);
  }
}

/// Adds the change along a straight line: left of a path is one more. Returns false if the line is
/// too near.
bool CountedSides::count(int f, const Vec2& from, const Vec2& to, Array<int>& counts) const {
  const Vec2 way = to - from;
  for (const Piece& piece : pieces_[f]) {
    const Vec2 along = piece.to - piece.from;
    const double length = along.norm();
    if (length == 0) continue;
    const double ends = way.norm();
    const double start = cross(along, from - piece.from) / length;
    const double end = cross(along, to - piece.from) / length;
    const double first = cross(way, piece.from - from) / ends;
    const double second = cross(way, piece.to - from) / ends;
    const auto apart = [](double a, double b) {
      return std::min(a, b) > kTooNear || std::max(a, b) < -kTooNear;
    };
    if (apart(start, end) || apart(first, second)) continue;
    for (const double distance : {start, end, first, second}) {
      if (std::abs(distance) < kTooNear) return false;
    }
    counts[piece.path] += end > 0 ? 1 : -1;
  }
  return true;
}

Array<int> CountedSides::change(int h, Random& random) const {
  const int f = faceOf(h);
  const int twin = mesh_.twin[h];
  const int other = faceOf(twin);
  const Array<Run>& runs = runs_[std::min(h, twin)];
  for (int trial = 0; trial < kTrials; ++trial) {
    const double t = random.uniform(0.01, 0.99);
    Array<int> counts(static_cast<size_t>(paths_), 0);
    const Vec2 place = onSide(cornerOf(h), t);
    const Vec2 across = onSide(cornerOf(twin), 1 - t);
    if (!isFree(f, place) || !isFree(other, across)) continue;
    if (!count(f, middle_[f], place, counts)) continue;
    // The face of the smaller half-edge is on its left.
    bool isNear = false;
    const double part = h < twin ? t : 1 - t;
    for (const Run& run : runs) {
      const double low = std::min(run.from, run.to);
      const double high = std::max(run.from, run.to);
      isNear = isNear || std::min(std::abs(part - low), std::abs(part - high)) < kTooNear;
      if (part < low || part > high) continue;
      counts[run.path] += (run.from < run.to) == (h < twin) ? -1 : 1;
    }
    if (isNear || !count(other, across, middle_[other], counts)) continue;
    return counts;
  }
  throw std::runtime_error("no place on an edge is free of paths");
}

bool CountedSides::bound(int first, int count, bool byParity) const {
  return std::all_of(defects_.begin(), defects_.end(), [&](const Array<int>& defect) {
    int sum = 0;
    for (int p = first; p < first + count; ++p) sum += defect[p];
    return byParity ? sum % 2 == 0 : sum == 0;
  });
}

std::optional<Array<int>> CountedSides::labels(const SurfacePoint& point) const {
  const Vec2 place(point.bary[1], point.bary[2]);
  if (!isFree(point.face, place)) return std::nullopt;
  Array<int> counts = labels_[point.face];
  if (!count(point.face, middle_[point.face], place, counts)) return std::nullopt;
  return counts;
}

}  // namespace karcher

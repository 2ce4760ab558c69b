#include "measures/polyline_distance.h"

#include <algorithm>

namespace karcher {
namespace {

Array<Box> boxesOfPieces(const Array<Vec3>& points) {
  Array<Box> boxes(points.size() - 1);
  for (int i = 0; i < boxes.count(); ++i) {
    boxes[i].include(points[i]);
    boxes[i].include(points[i + 1]);
  }
  return boxes;
}

/// A point of one polyline, and its distance from the other.
struct Probe {
  Vec3 place;
  int piece = 0;  // the nearest piece of the other polyline
  double distance = 0;
};

Probe probe(const MeasuredPolyline& other, const Vec3& place, int known) {
  const BoxTree::Nearest nearest = other.nearest(place, known);
  return {place, nearest.item, std::sqrt(nearest.squaredDistance)};
}

/// Raises `largest` to the largest distance between the probes. The distance from one piece is
/// convex along a straight line, so it is largest at the ends; and a distance grows by no more than
/// the length walked.
void widen(const MeasuredPolyline& other, const Probe& a, const Probe& b, double tolerance,
           double& largest) {
  if (a.piece == b.piece) return;
  const double most = (a.distance + b.distance + (b.place - a.place).norm()) / 2;
  if (most <= largest + tolerance) return;
  const Probe middle = probe(other, (a.place + b.place) / 2, a.piece);
  largest = std::max(largest, middle.distance);
  widen(other, a, middle, tolerance, largest);
  widen(other, middle, b, tolerance, largest);
}

void widen(const MeasuredPolyline& from, const MeasuredPolyline& other, double tolerance,
           double& largest) {
  Array<Probe> probes;
  for (const Vec3& place : from.points()) {
    probes.push_back(probe(other, place, probes.empty() ? 0 : probes.back().piece));
    largest = std::max(largest, probes.back().distance);
  }
  for (int i = 1; i < probes.count(); ++i) {
    widen(other, probes[i - 1], probes[i], tolerance, largest);
  }
}

}  // namespace

MeasuredPolyline::MeasuredPolyline(Array<Vec3> points)
    : points_(std::move(points)), tree_(boxesOfPieces(points_)) {}

double MeasuredPolyline::squaredDistance(int piece, const Vec3& q) const {
  const Vec3& a = points_[piece];
  const Vec3 along = points_[piece + 1] - a;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp((q - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (a + s * along - q).squaredNorm();
}

BoxTree::Nearest MeasuredPolyline::nearest(const Vec3& q, int known) const {
  const auto distance = [&](int piece, const Vec3& place) { return squaredDistance(piece, place); };
  return tree_.nearest(q, distance, {known, squaredDistance(known, q)});
}

double hausdorffDistance(const MeasuredPolyline& a, const MeasuredPolyline& b, double tolerance) {
  double largest = 0;
  widen(a, b, tolerance, largest);
  widen(b, a, tolerance, largest);
  return largest;
}

}  // namespace karcher

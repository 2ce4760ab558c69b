#include <algorithm>
#include <numbers>

#include "curves/query/measure.h"
#include "intrinsic/surface_path.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

/// The curve's point nearest to a place. The traced line bounds the curve's distance from the place
/// in each interval between samples. The search takes the intervals that may hold the nearest
/// point, the most promising first, and bisects them into parts inside one face of the mesh. In
/// such a part the curve is smooth and nearly straight, and golden sections find the minimum. At
/// edges of the mesh the curve may jump by a small fraction of an edge, with a minimum on either
/// side.
namespace karcher {
namespace {

/// The search assumes that the curve is at most so many times as long as its chord, between samples
/// and between the ends of a part.
constexpr double kBend = 2;
/// The least number of divisions of an interval between samples.
constexpr int kFewestCuts = 3;
/// The largest number of evaluations. Only curves that are equally near everywhere, such as a
/// circle around the place, reach it.
constexpr int kMostEvaluations = 20'000;

class NearestSearch {
 public:
  NearestSearch(Curve& curve, const Vec3& place) : curve_(curve), place_(place) {
    best_.distance = kInfinity;
  }

  NearestOnCurve run(const CurveLine& line) {
    const Array<Interval> intervals = intervalsOf(line);
    const Array<int> nearestFirst = sortedNumbers(intervals.count(), [&](int i, int j) {
      return intervals[i].distance < intervals[j].distance;
    });
    evaluate(intervals[nearestFirst[0]].nearest);
    for (const int i : nearestFirst) {
      const Interval& interval = intervals[i];
      if (interval.distance - kBend * interval.length > best_.distance) continue;
      search(evaluate(interval.from), evaluate(interval.to), 0);
    }
    return best_;
  }

 private:
  /// An interval between two samples, with the least distance of its line from the place.
  struct Interval {
    double from = 0;
    double to = 0;
    double nearest = 0;
    double distance = kInfinity;
    double length = 0;
  };
  /// A point of the curve and its distance from the place.
  struct Evaluation {
    double parameter = 0;
    double distance = 0;
    int face = -1;
    Vec3 position = Vec3::Zero();
  };

  Array<Interval> intervalsOf(const CurveLine& line) const {
    Array<Interval> intervals;
    int k = 0;  // the index of the line's piece
    for (int j = 0; j < curve_.segmentCount(); ++j) {
      const Array<CurveSample>& samples = curve_.samples(j);
      for (int i = 1; i < samples.count(); ++i) {
        Interval interval{j + samples[i - 1].t, j + samples[i].t};
        interval.nearest = interval.from;
        for (; k + 1 < line.path.points.count() && line.parameters[k + 1] <= interval.to; ++k) {
          const Vec3& a = line.positions[k];
          const Vec3 along = line.positions[k + 1] - a;
          const double squared = along.squaredNorm();
          const double s =
              squared > 0 ? std::clamp((place_ - a).dot(along) / squared, 0.0, 1.0) : 0;
          const double distance = (a + s * along - place_).norm();
          interval.length += std::sqrt(squared);
          if (distance >= interval.distance) continue;
          interval.distance = distance;
          interval.nearest = line.parameters[k] + s * (line.parameters[k + 1] - line.parameters[k]);
        }
        intervals.push_back(interval);
      }
    }
    return intervals;
  }

  Evaluation evaluate(double parameter) {
    const CurvePoint point = pointAt(curve_, parameter);
    const Vec3 here = position(curve_.surface().mesh(), point.point);
    const double distance = (here - place_).norm();
    if (distance < best_.distance) best_ = {point, distance};
    ++evaluations_;
    return {parameter, distance, point.point.face, here};
  }

  /// Searches the part between two evaluations.
  void search(const Evaluation& from, const Evaluation& to, int cuts) {
    const double width = to.parameter - from.parameter;
    const double chord = (to.position - from.position).norm();
    const double least = (from.distance + to.distance - kBend * chord) / 2;
    if (width <= kLocalRounding * (1 + to.parameter) || evaluations_ >= kMostEvaluations) return;
    if (cuts >= kFewestCuts && least >= best_.distance) return;
    const Evaluation middle = evaluate((from.parameter + to.parameter) / 2);
    const bool inOneFace = from.face == to.face && from.face == middle.face;
    if (cuts >= kFewestCuts && inOneFace) {
      goldenSections(from.parameter, to.parameter);
      return;
    }
    const bool firstIsNearer = from.distance < to.distance;
    if (firstIsNearer) search(from, middle, cuts + 1);
    search(middle, to, cuts + 1);
    if (!firstIsNearer) search(from, middle, cuts + 1);
  }

  void goldenSections(double from, double to) {
    const double golden = std::numbers::phi - 1;
    double left = to - golden * (to - from);
    double right = from + golden * (to - from);
    double atLeft = evaluate(left).distance;
    double atRight = evaluate(right).distance;
    while (to - from > kLocalRounding * (1 + to)) {
      if (atLeft < atRight) {
        to = right;
        right = left;
        atRight = atLeft;
        left = to - golden * (to - from);
        atLeft = evaluate(left).distance;
      } else {
        from = left;
        left = right;
        atLeft = atRight;
        right = from + golden * (to - from);
        atRight = evaluate(right).distance;
      }
    }
  }

  Curve& curve_;
  Vec3 place_;
  NearestOnCurve best_;
  int evaluations_ = 0;
};

}  // namespace

NearestOnCurve nearestOnCurve(Curve& curve, const CurveLine& line, const Vec3& place) {
  return NearestSearch(curve, place).run(line);
}

}  // namespace karcher

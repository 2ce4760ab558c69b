#include "curves/spec/curve_layout.h"

#include <algorithm>
#include <utility>

#include "curves/spec/knots.h"

namespace karcher {
namespace {

/// A segment that blends the control points `numbers`, one for each weight of the basis. If the
/// segment goes all around a closed curve, a number may occur several times. The segment's points
/// are then sorted, as in all other segments, so that adjacent segments agree where they meet.
SegmentLayout segmentOf(SegmentBasis basis, const Array<int>& numbers) {
  SegmentLayout segment;
  for (const int number : numbers) {
    const auto end = segment.points.end();
    if (std::find(segment.points.begin(), end, number) == end) segment.points.push_back(number);
  }
  if (segment.points.count() < numbers.count()) {
    std::sort(segment.points.begin(), segment.points.end());
    for (int k = 0; k < numbers.count(); ++k) {
      const auto place = std::find(segment.points.begin(), segment.points.end(), numbers[k]);
      basis.folds.push_back({k, static_cast<int>(place - segment.points.begin()), 1});
    }
  }
  basis.points = segment.points.count();
  segment.basis = std::move(basis);
  return segment;
}

Array<int> consecutive(int first, int count, int points) {
  Array<int> numbers;
  for (int k = first; k < first + count; ++k) numbers.push_back(k % points);
  return numbers;
}

Array<SegmentLayout> bsplineSegments(const CurveShape& shape, int points) {
  const int degree = shape.degree;
  const Array<double> knots = knotsOf(shape, points);
  Array<SegmentLayout> segments;
  for (int j = 0; j < spanCount(knots, degree, shape.closed); ++j) {
    const auto knot = [&](int k) { return knotOfSpan(knots, degree, shape.closed, k); };
    const double start = knot(j);
    const double length = knot(j + 1) - start;
    if (!(length > 0)) continue;
    SegmentBasis basis{BasisForm::kBSpline, degree};
    bool uniform = degree == 3;
    for (int k = -degree; k <= degree + 1; ++k) {
      // The first and the last knot are placeholders on which no weight depends.
      const int used = std::clamp(k, 1 - degree, degree);
      basis.numbers.push_back((knot(j + used) - start) / length);
      uniform = uniform && basis.numbers.back() == used;
    }
    // At a joint, the weights of this basis are the same numbers from both sides.
    if (uniform) basis = {BasisForm::kUniformCubic, degree};
    segments.push_back(segmentOf(std::move(basis), consecutive(j, degree + 1, points)));
  }
  return segments;
}

Array<SegmentLayout> catmullRomSegments(const CurveShape& shape, int points) {
  const int count = legCount(shape, points);
  Array<SegmentLayout> segments;
  for (int j = 0; j < count; ++j) {
    const bool first = !shape.closed && j == 0;
    const bool last = !shape.closed && j == count - 1;
    SegmentBasis basis{BasisForm::kCatmullRom, 3, {-1, 0, 1, 2}};
    if (!first && !last) {
      segments.push_back(segmentOf(std::move(basis), consecutive(j + points - 1, 4, points)));
      continue;
    }
    // Beyond an end, the curve continues to an imaginary point: the mirror image of the end's
    // neighbour in the end point.
    SegmentLayout segment;
    const int begin = first ? 0 : j - 1;
    const int end = last ? points - 1 : j + 2;
    for (int k = begin; k <= end; ++k) segment.points.push_back(k);
    const int start = j - begin;
    using Fold = SegmentBasis::Fold;
    if (first) {
      basis.folds.insert(basis.folds.end(), {Fold{0, 0, 2}, Fold{0, 1, -1}});
    } else {
      basis.folds.push_back({0, 0, 1});
    }
    basis.folds.insert(basis.folds.end(), {Fold{1, start, 1}, Fold{2, start + 1, 1}});
    if (last) {
      basis.folds.insert(basis.folds.end(), {Fold{3, start + 1, 2}, Fold{3, start, -1}});
    } else {
      basis.folds.push_back({3, start + 2, 1});
    }
    basis.points = segment.points.count();
    segment.basis = std::move(basis);
    segments.push_back(std::move(segment));
  }
  return segments;
}

}  // namespace

void catmullRomSpacings(const Array<double>& gaps, bool centripetal, Array<double>& spacings) {
  // Coincident points would give equal knots, and nearly coincident ones would lose digits.
  constexpr double kLeastGap = 1e-4;
  double largest = 0;
  for (const double gap : gaps) largest = std::max(largest, gap);
  spacings.clear();
  for (const double gap : gaps) {
    const bool even = !centripetal || !(largest > 0);
    spacings.push_back(even ? 1 : std::sqrt(std::max(gap / largest, kLeastGap)));
  }
}

void spaceKnots(const Array<double>& spacings, bool closed, Array<SegmentLayout>& segments) {
  const int count = segments.count();
  for (int j = 0; j < count; ++j) {
    // Beyond an end, the knots repeat the span at that end.
    const int before = j > 0 ? j - 1 : closed ? count - 1 : 0;
    const int after = j + 1 < count ? j + 1 : closed ? 0 : count - 1;
    segments[j].basis.numbers.assign(
        {-spacings[before] / spacings[j], 0, 1, 1 + spacings[after] / spacings[j]});
  }
}

Array<SegmentLayout> layOut(const CurveShape& shape, int points) {
  // A closed curve of one segment ends at its first point.
  const Array<int> all = consecutive(0, shape.closed ? points + 1 : points, points);
  const int last = all.count() - 1;
  switch (shape.kind) {
    case CurveKind::kBSpline:
      return bsplineSegments(shape, points);
    case CurveKind::kCatmullRom:
      return catmullRomSegments(shape, points);
    case CurveKind::kPolyline: {
      Array<SegmentLayout> segments;
      for (int j = 0; j < last; ++j) segments.push_back(segmentOf({}, {all[j], all[j + 1]}));
      return segments;
    }
    case CurveKind::kBarycentric: {
      Array<double> betas = shape.betas;
      betas.resize(static_cast<size_t>(points), 1);
      if (shape.closed) betas.push_back(betas[0]);
      return {segmentOf({BasisForm::kBarycentric, last, betas}, all)};
    }
    case CurveKind::kOwn:
      return {segmentOf({BasisForm::kOwn, last, {}, shape.basis, shape.isBasisMirrored}, all)};
    case CurveKind::kBezier:
    case CurveKind::kRational:
      break;
  }
  return {segmentOf({BasisForm::kBernstein, last}, all)};
}

bool layAlike(const CurveShape& a, const CurveShape& b) {
  return a.kind == b.kind && a.closed == b.closed && a.degree == b.degree &&
         a.knotRule == b.knotRule && a.knots == b.knots && a.betas == b.betas &&
         a.basis == b.basis && a.isBasisMirrored == b.isBasisMirrored;
}

}  // namespace karcher

#include "curves/spec/curve_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "curve_support.h"
#include "curves/spec/bases.h"
#include "curves/spec/knots.h"
#include "generators/random.h"
#include "support.h"

namespace karcher {
namespace {

const Array<double> kOwnKnots{0, 0.5, 0.5, 1, 1.2, 2.5, 2.5, 4, 5, 5.5};

CurveShape bspline(int degree, bool closed, KnotRule rule = KnotRule::kUniform,
                   const Array<double>& knots = {}) {
  return {CurveKind::kBSpline, closed, degree, rule, knots};
}

/// Every kind of curve of six points.
Array<CurveShape> sixPointShapes() {
  Array<CurveShape> all;
  for (int degree = 1; degree <= 5; ++degree) {
    all.push_back(bspline(degree, false));
    all.push_back(bspline(degree, false, KnotRule::kClamped));
    all.push_back(bspline(degree, true));
  }
  all.push_back(bspline(3, false, KnotRule::kOwn, kOwnKnots));
  all.push_back(bspline(2, true, KnotRule::kOwn, {0, 1, 1, 3, 3.5, 4, 6}));
  all.push_back(bspline(5, true, KnotRule::kOwn, {0, 1, 1.5, 3, 3.5, 4, 6}));
  for (const bool closed : {false, true}) {
    for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kRational, CurveKind::kBarycentric,
                                 CurveKind::kCatmullRom, CurveKind::kPolyline}) {
      all.push_back({kind, closed});
      if (takesBetas(kind)) all.back().betas = {1, 2, 0.5, 3, 1, 1};
    }
    all.push_back({CurveKind::kCatmullRom, closed});
    all.back().centripetal = false;
  }
  return all;
}

constexpr int kPoints = 6;
const Array<double> kGaps{1, 2, 0.5, 0, 3, 1};

/// The segments, with knots spaced by the gaps, if any.
Array<SegmentLayout> layOutSpaced(const CurveShape& shape, const Array<double>& gaps) {
  Array<SegmentLayout> segments = layOut(shape, kPoints);
  if (shape.kind == CurveKind::kCatmullRom) {
    Array<double> spacings;
    catmullRomSpacings(gaps, shape.centripetal, spacings);
    spaceKnots(spacings, shape.closed, segments);
  }
  return segments;
}

Array<SegmentLayout> layOutSix(const CurveShape& shape) {
  Array<double> gaps = kGaps;
  if (!shape.closed) gaps.pop_back();
  return layOutSpaced(shape, gaps);
}

/// The weights of all control points at t in a segment.
Array<double> spread(const SegmentLayout& segment, double t) {
  Array<double> all(kPoints, 0.0);
  const Array<double> weights = weightsAt(segment.basis, t);
  EXPECT_EQ(weights.count(), segment.points.count());
  for (int k = 0; k < weights.count(); ++k) all[segment.points[k]] += weights[k];
  return all;
}

TEST(CurveLayout, SegmentsArePartitionsOfUnityAndMeet) {
  for (const CurveShape& shape : sixPointShapes()) {
    SCOPED_TRACE(describe(shape));
    EXPECT_NO_THROW(checkGivenShape(shape, kPoints));
    const Array<SegmentLayout> segments = layOutSix(shape);
    ASSERT_FALSE(segments.empty());
    for (const SegmentLayout& segment : segments) {
      for (int i = 0; i <= 20; ++i) {
        EXPECT_NEAR(weightedSum(spread(segment, i / 20.0), Array<double>(kPoints, 1.0)), 1, 1e-12);
      }
    }
    const int joints = segments.count() - (shape.closed ? 0 : 1);
    for (int j = 0; j < joints; ++j) {
      const Array<double> end = spread(segments[j], 1);
      const Array<double> start = spread(segments[(j + 1) % segments.count()], 0);
      for (int i = 0; i < kPoints; ++i) EXPECT_NEAR(end[i], start[i], 1e-13);
    }
  }
}

TEST(CurveLayout, HasTheNumberOfSegmentsOfItsKind) {
  const auto count = [](const CurveShape& shape) { return layOutSix(shape).count(); };
  EXPECT_EQ(count(bspline(3, false)), 3);
  EXPECT_EQ(count(bspline(3, true)), 6);
  EXPECT_EQ(count(bspline(1, false)), 5);
  EXPECT_EQ(count(bspline(3, false, KnotRule::kOwn, kOwnKnots)), 2);  // a span is empty
  EXPECT_EQ(count({CurveKind::kBezier}), 1);
  EXPECT_EQ(count({CurveKind::kCatmullRom}), 5);
  EXPECT_EQ(count({CurveKind::kCatmullRom, true}), 6);
  EXPECT_EQ(count({CurveKind::kPolyline, true}), 6);
  // Uniform segments share one basis, and thus one table.
  const Array<SegmentLayout> uniform = layOutSix(bspline(4, true));
  for (const SegmentLayout& segment : uniform) EXPECT_EQ(segment.basis, uniform[0].basis);
}

TEST(CurveLayout, ClampedAndInterpolatingCurvesPassTheirPoints) {
  for (const CurveShape& shape :
       {bspline(3, false, KnotRule::kClamped), CurveShape{CurveKind::kBezier},
        CurveShape{CurveKind::kRational}, CurveShape{CurveKind::kBarycentric},
        CurveShape{CurveKind::kCatmullRom}, CurveShape{CurveKind::kPolyline}}) {
    SCOPED_TRACE(describe(shape));
    const Array<SegmentLayout> segments = layOutSix(shape);
    EXPECT_NEAR(spread(segments[0], 0)[0], 1, 1e-14);
    EXPECT_NEAR(spread(segments[segments.count() - 1], 1)[kPoints - 1], 1, 1e-14);
    if (segments.count() < kPoints - 1) continue;
    for (int j = 0; j < segments.count(); ++j) EXPECT_NEAR(spread(segments[j], 0)[j], 1, 1e-14);
  }
}

/// The largest jump of the k-th derivative with respect to the curve's own parameter between
/// segments of a closed curve with numbers as points, by one-sided differences.
double largestJump(const Array<SegmentLayout>& segments, const Array<double>& lengths, int k) {
  const Array<double> values{0.3, -1, 2, 0.7, 1.1, -0.4};
  constexpr double kStep = 0.01;
  const auto derivative = [&](int j, double at, double direction) {
    // Polynomials of degree at most 5: six values determine every derivative.
    Array<double> differences;
    for (int i = 0; i <= 5; ++i) {
      differences.push_back(weightedSum(spread(segments[j], at + direction * i * kStep), values));
    }
    // Forward differences are the Newton form; its derivative is that at the first value.
    Array<double> coefficients;
    for (int order = 0; order <= 5; ++order) {
      coefficients.push_back(differences[0]);
      for (int i = 0; i + 1 < differences.count(); ++i)
        differences[i] = differences[i + 1] - differences[i];
      differences.pop_back();
    }
    // D^n f is a sum with the Stirling numbers of the logarithm series.
    const double first = coefficients[1] - coefficients[2] / 2 + coefficients[3] / 3 -
                         coefficients[4] / 4 + coefficients[5] / 5;
    const double second =
        coefficients[2] - coefficients[3] + 11 * coefficients[4] / 12 - 5 * coefficients[5] / 6;
    const double step = direction * kStep * lengths[j];
    return k == 1 ? first / step : second / (step * step);
  };
  double worst = 0;
  const int count = segments.count();
  for (int j = 0; j < count; ++j) {
    worst = std::max(worst, std::abs(derivative(j, 1, -1) - derivative((j + 1) % count, 0, 1)));
  }
  return worst;
}

TEST(CurveLayout, JoinsAreAsSmoothAsTheKindPromises) {
  const Array<double> even(kPoints, 1.0);
  EXPECT_LT(largestJump(layOutSix(bspline(2, true)), even, 1), 1e-10);
  EXPECT_GT(largestJump(layOutSix(bspline(2, true)), even, 2), 0.1);
  for (int degree = 3; degree <= 5; ++degree) {
    EXPECT_LT(largestJump(layOutSix(bspline(degree, true)), even, 1), 1e-10);
    EXPECT_LT(largestJump(layOutSix(bspline(degree, true)), even, 2), 1e-8);
  }
  const Array<double> spans{1, 0.5, 1.5, 0.5, 0.5, 2};
  const CurveShape own = bspline(4, true, KnotRule::kOwn, {0, 1, 1.5, 3, 3.5, 4, 6});
  EXPECT_LT(largestJump(layOutSix(own), spans, 1), 1e-10);
  EXPECT_LT(largestJump(layOutSix(own), spans, 2), 1e-8);

  CurveShape uniform{CurveKind::kCatmullRom, true};
  uniform.centripetal = false;
  EXPECT_LT(largestJump(layOutSix(uniform), even, 1), 1e-10);
  Array<double> gaps{1, 2, 0.5, 0.3, 3, 1};
  Array<double> roots;
  for (const double gap : gaps) roots.push_back(std::sqrt(gap));
  EXPECT_LT(largestJump(layOutSpaced({CurveKind::kCatmullRom, true}, gaps), roots, 1), 1e-10);
}

TEST(CurveLayout, ReversedCurvesRunBackwards) {
  const Array<double> values{0.3, -1, 2, 0.7, 1.1, -0.4};
  for (const CurveShape& shape : sixPointShapes()) {
    SCOPED_TRACE(describe(shape));
    const Array<SegmentLayout> segments = layOutSix(shape);
    Array<double> backwards = values;
    reverseEntries(backwards, shape.closed);
    // In closed curves the last gap leads back to the first point.
    Array<double> gaps(kGaps.rbegin(), kGaps.rend());
    if (!shape.closed) gaps.erase(gaps.begin());
    const Array<SegmentLayout> others = layOutSpaced(reversed(shape), gaps);
    ASSERT_EQ(segments.count(), others.count());
    // A closed B-spline starts with another segment: one of the segments has the value.
    for (int j = 0; j < segments.count(); ++j) {
      const double value = weightedSum(spread(segments[j], 0.3), values);
      double nearest = kInfinity;
      for (const SegmentLayout& other : others) {
        nearest = std::min(nearest, std::abs(weightedSum(spread(other, 0.7), backwards) - value));
      }
      EXPECT_LT(nearest, 1e-12);
    }
  }
}

TEST(CurveLayout, KeepsCustomKnotsValidThroughEdits) {
  const uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  CurveShape shape = bspline(3, false, KnotRule::kOwn, kOwnKnots);
  int points = kPoints;
  for (int edit = 0; edit < 300; ++edit) {
    const int i = random.index(points);
    CurveShape changed = shape;
    int count = points;
    switch (random.index(5)) {
      case 0:
      case 1:
        changed = withPoint(shape, i);
        ++count;
        break;
      case 2:
        changed = withoutPoint(shape, points, i);
        --count;
        break;
      case 3:
        changed = withClosed(shape, !shape.closed);
        break;
      default:
        changed = reversed(shape);
    }
    try {
      checkShape(changed, count);
    } catch (const Error& error) {
      // Only the requested change may be invalid, and multiple knots that become inner ones.
      EXPECT_TRUE(count < 4 || std::string(error.what()).find("occurs") != std::string::npos)
          << error.what();
      continue;
    }
    shape = changed;
    points = count;
    if (points > 12) shape = bspline(3, false, KnotRule::kOwn, kOwnKnots), points = kPoints;
  }
}

/// A segment by the names of its points, and its knots from the start of its span.
struct NamedSegment {
  Array<int> points;
  Array<double> knots;
  bool operator==(const NamedSegment&) const = default;
};

Array<NamedSegment> namedSegments(const Array<double>& knots, int degree, const Array<int>& names) {
  Array<NamedSegment> all;
  for (int j = 0; j < names.count(); ++j) {
    NamedSegment segment;
    for (int k = 0; k <= degree; ++k) segment.points.push_back(names[(j + k) % names.count()]);
    for (int k = 1 - degree; k <= degree; ++k) {
      segment.knots.push_back(knotOfSpan(knots, degree, true, j + k) -
                              knotOfSpan(knots, degree, true, j));
    }
    all.push_back(segment);
  }
  return all;
}

int countShared(const Array<NamedSegment>& a, const Array<NamedSegment>& b) {
  return static_cast<int>(std::count_if(a.begin(), a.end(), [&](const NamedSegment& segment) {
    return std::find(b.begin(), b.end(), segment) != b.end();
  }));
}

TEST(CurveLayout, EditsOfAClosedCurveKeepTheSegmentsThatTheyDoNotReach) {
  const uint64_t seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const int degree : {1, 2, 3, 5}) {
    for (int points = 2; points <= 13; ++points) {
      // Multiples of 1/8, so that sums are exact.
      Array<double> knots{random.index(8) / 8.0};
      for (int k = 0; k < points; ++k) knots.push_back(knots.back() + (1 + random.index(30)) / 4.0);
      Array<int> names;
      for (int k = 0; k < points; ++k) names.push_back(k);
      const Array<NamedSegment> before = namedSegments(knots, degree, names);
      for (int i = 0; i <= points; ++i) {
        SCOPED_TRACE("degree " + std::to_string(degree) + ", " + std::to_string(points) +
                     " points, point " + std::to_string(i));
        const Array<double> more = knotsWithPoint(knots, degree, true, i);
        ASSERT_EQ(more.count(), points + 2);
        EXPECT_EQ(knotsWithoutPoint(more, degree, true, i), knots);
        Array<int> named = names;
        named.insert(named.begin() + i, -1);
        // The new knot divides the span of 2 p - 1 segments.
        EXPECT_EQ(countShared(before, namedSegments(more, degree, named)),
                  std::max(points - (2 * degree - 1), 0));
        if (i == points || points == 2) continue;
        const Array<double> fewer = knotsWithoutPoint(knots, degree, true, i);
        ASSERT_EQ(fewer.count(), points);
        named = names;
        named.erase(named.begin() + i);
        EXPECT_EQ(countShared(before, namedSegments(fewer, degree, named)),
                  std::max(points - 2 * degree, 0));
      }
    }
  }
}

TEST(CurveLayout, EditsOfAClosedCurveKeepItsDoubleKnots) {
  const uint64_t seed = 13;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int round = 0; round < 100; ++round) {
    const int points = 6;
    Array<double> knots{random.uniform(-3, 3)};
    for (int k = 1; k < points; ++k) knots.push_back(knots.back() + random.uniform(0.1, 2));
    // The last knot of a turn, which is the first one of the next turn, is double.
    knots.push_back(knots.back());
    for (int i = 0; i < points; ++i) {
      EXPECT_NO_THROW(checkKnots(knotsWithPoint(knots, 3, true, i), points + 1, 3, true));
      EXPECT_NO_THROW(checkKnots(knotsWithoutPoint(knots, 3, true, i), points - 1, 3, true));
    }
    const double before = knotOfSpan(knots, 3, true, -1);
    EXPECT_EQ(before, knots.front());
  }
}

TEST(CurveLayout, OpeningAClosedCurveKeepsItsFirstSegments) {
  const CurveShape closed = bspline(3, true, KnotRule::kOwn, {0, 1, 1.5, 3, 3.5, 4, 6});
  const Array<SegmentLayout> all = layOutSix(closed);
  const Array<SegmentLayout> open = layOutSix(withClosed(closed, false));
  ASSERT_EQ(open.count(), 3);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= 4; ++i) {
      const Array<double> a = spread(all[j], i / 4.0);
      const Array<double> b = spread(open[j], i / 4.0);
      for (int k = 0; k < kPoints; ++k) EXPECT_NEAR(a[k], b[k], 1e-14);
    }
  }
}

TEST(CurveLayout, RefusesInvalidShapes) {
  const auto code = [](const CurveShape& shape, int points) {
    return codeOf([&] { checkGivenShape(shape, points); });
  };
  const auto knots = [](const Array<double>& own) {
    return bspline(2, false, KnotRule::kOwn, own);
  };
  EXPECT_EQ(code(bspline(3, false), 3), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code(bspline(3, true), 2), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code(bspline(0, false), 5), ErrorCode::kBadArgument);
  EXPECT_EQ(code(bspline(6, false), 9), ErrorCode::kBadArgument);
  EXPECT_EQ(code(bspline(3, true, KnotRule::kClamped), 6), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 1, 2, 3, 4}), 3), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 1, 3, 2, 4, 5}), 3), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 1, 2, 2, 4, 5}), 3), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 1, 2, 3, 4, kInfinity}), 3), ErrorCode::kNotFinite);
  EXPECT_EQ(code(knots({0, 0, 0, 1, 1, 1, 2, 2, 2}), 6), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({-1e308, 0, 1, 2, 3, 1e308}), 3), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 1, 2, 2 + 4e-16, 1e100, 1e101}), 3), ErrorCode::kBadArgument);
  EXPECT_EQ(code(knots({0, 0, 0, 5e-324, 5e-324, 1}), 3), ErrorCode::kBadArgument);
  EXPECT_NO_THROW(checkGivenShape(knots({-1e100, -1, 0, 1e-100, 1, 1e100}), 3));
  EXPECT_EQ(code({CurveKind::kBezier}, 1), ErrorCode::kTooFewPoints);
  EXPECT_EQ(code({CurveKind::kBezier}, 1001), ErrorCode::kBadArgument);
  EXPECT_EQ(code({CurveKind::kOwn}, 3), ErrorCode::kBadArgument);
  CurveShape weighted{CurveKind::kRational};
  weighted.weights = {1, 0, 1};
  EXPECT_EQ(code(weighted, 3), ErrorCode::kBadArgument);
  weighted.weights = {1, 2};
  EXPECT_EQ(code(weighted, 3), ErrorCode::kBadArgument);
  weighted.weights = {1, kInfinity, 1};
  EXPECT_EQ(code(weighted, 3), ErrorCode::kNotFinite);
  weighted.weights = {1, 2, 1};
  EXPECT_NO_THROW(checkGivenShape(weighted, 3));
  weighted.kind = CurveKind::kBezier;
  EXPECT_EQ(code(weighted, 3), ErrorCode::kBadArgument);
  EXPECT_NO_THROW(checkShape(weighted, 3));
}

TEST(CurveLayout, RefusesABasisThatIsNoPartitionOfUnity) {
  CurveShape shape{CurveKind::kOwn};
  shape.basis = std::make_shared<OwnBasis>([](int points, double t) {
    Array<double> weights = bernsteinBasis(points - 1, t);
    if (t > 0.7) weights[0] += 0.1;
    return weights;
  });
  const SegmentBasis basis = layOut(shape, 4)[0].basis;
  EXPECT_EQ(weightsAt(basis, 0.5), bernsteinBasis(3, 0.5));
  EXPECT_EQ(codeOf([&] { weightsAt(basis, 0.8); }), ErrorCode::kBadWeights);
}

TEST(CurveLayout, TheWidestKnotsGiveFiniteWeights) {
  for (const Array<double>& own : {Array<double>{-1e100, -1, 0, 1e-100, 1, 1e100},
                                   Array<double>{-1e100, -1e100, 0, 1e100, 1e100, 1e100}}) {
    for (const SegmentLayout& segment : layOut(bspline(2, false, KnotRule::kOwn, own), 3)) {
      for (const double t : {0.0, 0.3, 1.0}) {
        double sum = 0;
        for (const double weight : weightsAt(segment.basis, t)) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-12);
      }
    }
  }
}

TEST(CurveLayout, ReportsTheSumOfWrongWeights) {
  CurveShape shape{CurveKind::kOwn};
  shape.basis = std::make_shared<OwnBasis>([](int points, double t) {
    Array<double> weights = bernsteinBasis(points - 1, t);
    weights[0] += 1e-8;
    return weights;
  });
  try {
    weightsAt(layOut(shape, 4)[0].basis, 0.5);
    FAIL() << "weights of another sum were taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("1.00000001"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace karcher

#include "curves/spec/knots.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// The largest absolute value of a knot. A nonempty span is at least 1 / kMostKnot long, so that
/// quotients stay finite.
constexpr double kMostKnot = 1e100;

/// k modulo n, from 0 to n - 1.
int wrapped(int k, int n) { return ((k % n) + n) % n; }

Array<double> spansOf(const Array<double>& knots) {
  Array<double> spans;
  for (int k = 1; k < knots.count(); ++k) spans.push_back(knots[k] - knots[k - 1]);
  return spans;
}

Array<double> knotsOfSpans(double first, const Array<double>& spans) {
  Array<double> knots{first};
  for (const double span : spans) knots.push_back(knots.back() + span);
  return knots;
}

/// The span before the middle knot of control point i's support. It may lie outside the spans.
int middleSpan(int i, int degree) { return i - (degree + 1) / 2; }

void checkRepeats(const Array<double>& knots, int degree, bool closed) {
  const int first = closed ? 0 : degree;
  const int last = knots.count() - 1 - (closed ? 0 : degree);
  for (int k = 0; k < knots.count(); ++k) {
    // The last knot of a closed curve is the first one again.
    if (closed && k == last) break;
    int repeats = 0;
    for (const double knot : knots) repeats += knot == knots[k];
    if (closed && knots[k] == knots[0]) {
      for (const double knot : knots) repeats += knot == knots[last];
      repeats -= 1;
    }
    const bool atEnd = !closed && (knots[k] == knots[first] || knots[k] == knots[last]);
    const int most = atEnd ? degree + 1 : degree;
    if (repeats > most) {
      refuse("knot " + std::to_string(k) + " occurs " + std::to_string(repeats) +
             " times; degree " + std::to_string(degree) + " allows " + std::to_string(most) +
             (atEnd ? " at the ends" : ""));
    }
  }
}

}  // namespace

Array<double> uniformKnots(int points, int degree, bool closed) {
  Array<double> knots;
  const int first = closed ? 0 : -degree;
  for (int k = first; k <= points; ++k) knots.push_back(k);
  return knots;
}

Array<double> clampedKnots(int points, int degree) {
  Array<double> knots;
  for (int k = -degree; k <= points; ++k) knots.push_back(std::clamp(k, 0, points - degree));
  return knots;
}

void checkKnots(const Array<double>& knots, int points, int degree, bool closed) {
  const int needed = closed ? points + 1 : points + degree + 1;
  if (knots.count() != needed) {
    refuse((closed ? "a closed B-spline of " : "a B-spline of ") + std::to_string(points) +
           " points and degree " + std::to_string(degree) + " takes " + std::to_string(needed) +
           " knots, not " + std::to_string(knots.count()));
  }
  for (int k = 0; k < knots.count(); ++k) {
    if (!std::isfinite(knots[k])) {
      throw Error(ErrorCode::kNotFinite, "knot " + std::to_string(k) + " is not a finite number");
    }
    if (std::abs(knots[k]) > kMostKnot) {
      refuse("knot " + std::to_string(k) + " is " + inSentence(knots[k]) +
             "; knots go from -1e100 to 1e100");
    }
    if (k == 0) continue;
    if (knots[k] < knots[k - 1]) {
      refuse("knot " + std::to_string(k) + " is " + inFull(knots[k]) + ", less than knot " +
             std::to_string(k - 1) + ", which is " + inFull(knots[k - 1]));
    }
    if (knots[k] > knots[k - 1] && knots[k] - knots[k - 1] < 1 / kMostKnot) {
      refuse("knot " + std::to_string(k) + " lies " + inSentence(knots[k] - knots[k - 1]) +
             " after knot " + std::to_string(k - 1) + "; knots are equal or at least 1e-100 apart");
    }
  }
  const int spans = spanCount(knots, degree, closed);
  if (!(knotOfSpan(knots, degree, closed, spans) > knotOfSpan(knots, degree, closed, 0))) {
    refuse("the knots leave no span for a segment: those in the middle are all equal");
  }
  checkRepeats(knots, degree, closed);
}

int spanCount(const Array<double>& knots, int degree, bool closed) {
  return closed ? knots.count() - 1 : knots.count() - 1 - 2 * degree;
}

double knotOfSpan(const Array<double>& knots, int degree, bool closed, int j) {
  if (!closed) return knots[j + degree];
  const int spans = knots.count() - 1;
  const int k = wrapped(j, spans);
  const int turns = (j - k) / spans;
  // Only other turns add the period, so that uniform knots stay integers. Differences from the near
  // end keep knots there equal.
  if (turns == 0) return knots[k];
  const double period = knots.back() - knots.front();
  return turns > 0 ? knots.back() + (knots[k] - knots.front()) + (turns - 1) * period
                   : knots.front() - (knots.back() - knots[k]) + (turns + 1) * period;
}

Array<double> knotsWithPoint(const Array<double>& knots, int degree, bool closed, int i) {
  const int spans = spanCount(knots, degree, closed);
  const int middle = middleSpan(i, degree);
  int span = closed ? wrapped(middle, spans) : std::clamp(middle, 0, spans - 1);
  // The new knots before knot 0 of a closed curve, one in each turn.
  const int before0 = closed ? (span - middle) / spans : 0;
  const auto lengthOf = [&](int j) {
    return knotOfSpan(knots, degree, closed, j + 1) - knotOfSpan(knots, degree, closed, j);
  };
  // The nearest span that is not empty.
  for (int away = 0; away < spans; ++away) {
    const int before = std::max(span - away, 0);
    const int after = std::min(span + away, spans - 1);
    if (lengthOf(before) > 0 || lengthOf(after) > 0) {
      span = lengthOf(before) > 0 ? before : after;
      break;
    }
  }
  const int k = span + (closed ? 0 : degree);
  Array<double> result = knots;
  result.insert(result.begin() + k + 1, (knots[k] + knots[k + 1]) / 2);
  if (before0 == 0) return result;
  // Knot 0 moves up with its points.
  Array<double> moved;
  for (int j = 0; j < result.count(); ++j) {
    moved.push_back(knotOfSpan(result, degree, true, j - before0));
  }
  return moved;
}

Array<double> knotsWithoutPoint(const Array<double>& knots, int degree, bool closed, int i) {
  const int spans = spanCount(knots, degree, closed);
  Array<double> result = knots;
  const int k = middleSpan(i, degree) + 1;
  if (closed) {
    // Each removed knot before the new knot 0, one in each turn, moves knot 0 down with its points.
    const int first = k < 1 ? 1 - k / (spans - 1) : 0;
    result.clear();
    for (int j = first; j <= first + spans; ++j) {
      if (wrapped(j - k, spans) != 0) result.push_back(knotOfSpan(knots, degree, true, j));
    }
  } else {
    result.erase(result.begin() + degree + std::clamp(k, 1, spans - 1));
  }
  return result;
}

Array<double> reversedKnots(const Array<double>& knots, int degree, bool closed) {
  Array<double> spans = spansOf(knots);
  std::reverse(spans.begin(), spans.end());
  if (closed) {
    // Span j blends the points j to j + p. In the reversed curve these are the points n - j - p to
    // n - j, which span n - j - p blends.
    std::rotate(spans.begin(), spans.begin() + wrapped(degree - 1, spans.count()), spans.end());
  }
  return knotsOfSpans(knots.front(), spans);
}

Array<double> closedKnots(const Array<double>& open, int degree) {
  const Array<double> inner(open.begin() + degree, open.end() - degree);
  Array<double> spans = spansOf(inner);
  const double mean = (inner.back() - inner.front()) / static_cast<double>(spans.size());
  spans.insert(spans.end(), static_cast<size_t>(degree), mean);
  return knotsOfSpans(inner.front(), spans);
}

Array<double> openKnots(const Array<double>& closed, int degree) {
  Array<double> knots;
  const int points = closed.count() - 1;
  for (int j = -degree; j <= points; ++j) knots.push_back(knotOfSpan(closed, degree, true, j));
  return knots;
}

}  // namespace karcher

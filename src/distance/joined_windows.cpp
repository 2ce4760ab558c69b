#include "distance/joined_windows.h"

#include <algorithm>
#include <tuple>

#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// The largest distance of a joint source from its window, in widths of the window. The source of
/// an almost straight front gets this distance.
constexpr double kFarthestSource = 1000;

/// The slope of distances along the edge at x: the cosine of the angle between the ray through x
/// and the edge.
double slopeAt(const Window& w, double x) {
  return (x - w.sourceX) / std::sqrt(squaredLegTo(w, x));
}

/// The length by which distances through a window exceed those through another.
double excessAt(const Window& w, const Window& other, double x) {
  return distanceAt(w, x) - distanceAt(other, x);
}

/// The extremum of the excess between two places, or 0 if there is none. It lies where the line
/// through both sources meets the edge, since there both slopes are equal.
double excessBetween(const Window& w, const Window& other, double from, double to) {
  const double x = (w.sourceX * other.depth - other.sourceX * w.depth) / (other.depth - w.depth);
  return from < x && x < to ? excessAt(w, other, x) : 0;
}

/// A window's changes by all joins so far.
struct Origin {
  double change = 0;      ///< a bound on the changes of distances along the edge so far
  double beginSlope = 0;  ///< the original slope at the window's begin, if `change` > 0
};

/// Joins two windows that touch, neither of which contains the other, into one over both. The joint
/// source keeps the distances at the two outer ends. These, together with the distance where the
/// windows meet, determine the front's curvature, and so the offset. Returns false if distances
/// along the edge would change by more than the tolerance, or if there is no such source. Windows
/// with a gap between them do not join: what is behind the gap may lie in a shadow.
bool join(Window& first, const Window& second, double mostChange, Origin& origin) {
  const double tolerance = mostChange - origin.change;
  const double begin = first.begin;
  const double end = second.end;
  const double width = end - begin;
  if (second.begin - first.end > kChainRounding * width) return false;
  const double middle = (std::min(first.end, end) + second.begin) / 2;
  const double left = middle - begin;
  const double right = end - middle;
  const double firstLeg = std::sqrt(squaredLegTo(first, middle));
  const double secondLeg = std::sqrt(squaredLegTo(second, middle));
  if (first.offset == second.offset) {
    const double apart = std::hypot(first.sourceX - second.sourceX, first.depth - second.depth);
    if (apart <= kChainRounding * firstLeg) {
      first.end = end;
      return true;
    }
  }
  const double throughFirst = first.offset + firstLeg;
  const double throughSecond = second.offset + secondLeg;
  double change = std::abs(throughFirst - throughSecond);
  if (!(change <= tolerance)) return false;

  const double atBegin = distanceAt(first, begin);
  const double atMiddle = std::min(throughFirst, throughSecond);
  const double atEnd = distanceAt(second, end);
  // Squared legs along the edge are x^2 plus a linear function.
  const double bend = (atEnd - atMiddle) * left - (atMiddle - atBegin) * right;
  const double squares = (atEnd - atMiddle) * (atEnd + atMiddle) * left -
                         (atMiddle - atBegin) * (atMiddle + atBegin) * right - left * right * width;
  const double leastOffset = atMiddle - kFarthestSource * width;
  Window joint = second.end - second.begin > first.end - first.begin ? second : first;
  joint.begin = begin;
  joint.end = end;
  joint.offset = bend > 0 ? std::max(squares / (2 * bend), leastOffset) : leastOffset;
  // The joint window must reach all places that the two windows reach beyond its edge, since no
  // other window may reach them. A nearer source spreads the rays at both ends.
  if (origin.change == 0) origin.beginSlope = slopeAt(first, begin);
  const double rise = atEnd - atBegin;
  const auto spread = [&](double excess, double distance) {
    if (excess <= 0) return;
    joint.offset =
        std::max(joint.offset, distance - (width - rise) * (width + rise) / (2 * excess));
  };
  spread(rise - width * origin.beginSlope, atBegin);
  spread(width * slopeAt(second, end) - rise, atEnd);
  const double beginLeg = atBegin - joint.offset;
  const double endLeg = atEnd - joint.offset;
  const double x = ((beginLeg - endLeg) * (beginLeg + endLeg) / width + width) / 2;
  const double squaredDepth = square(beginLeg) - square(x);
  if (!(beginLeg >= 0 && endLeg >= 0 && squaredDepth >= 0)) return false;
  joint.sourceX = begin + x;
  joint.depth = std::sqrt(squaredDepth);
  // On each side of the middle, the joint window is compared with the original window.
  const double firstEnd = std::min(first.end, middle);
  const double secondBegin = std::max(second.begin, middle);
  for (const double excess :
       {excessAt(joint, first, firstEnd), excessBetween(joint, first, begin, firstEnd),
        excessAt(joint, second, secondBegin), excessBetween(joint, second, secondBegin, end)}) {
    change = std::max(change, std::abs(excess));
  }
  if (!(change <= tolerance)) return false;
  origin.change += change;
  first = joint;
  return true;
}

/// The largest amount by which distances through a wider window exceed those through a window that
/// lies in it; kInfinity if the two share an end at which the ray of the wider window turns
/// inwards.
double excessOf(const Window& wider, const Window& window) {
  const bool reaches =
      (window.begin > wider.begin || slopeAt(wider, wider.begin) <= slopeAt(window, wider.begin)) &&
      (window.end < wider.end || slopeAt(wider, wider.end) >= slopeAt(window, wider.end));
  if (!reaches) return kInfinity;
  return std::max({excessAt(wider, window, window.begin), excessAt(wider, window, window.end),
                   excessBetween(wider, window, window.begin, window.end), 0.0});
}

bool isBefore(const Window& a, const Window& b) {
  if (a.begin != b.begin) return a.begin < b.begin;
  return std::tie(a.end, a.sourceX, a.depth, a.offset) <
         std::tie(b.end, b.sourceX, b.depth, b.offset);
}

/// Most batches have few windows, for which insertion sort is fastest.
void sortByPlace(Array<Window>& windows) {
  constexpr int kFew = 16;
  if (windows.count() > kFew) {
    sortItems(windows, isBefore);
    return;
  }
  for (int i = 1; i < windows.count(); ++i) {
    const Window window = windows[i];
    int j = i;
    for (; j > 0 && isBefore(window, windows[j - 1]); --j) windows[j] = windows[j - 1];
    windows[j] = window;
  }
}

}  // namespace

void joinWindows(double mostChange, Array<Window>& windows) {
  sortByPlace(windows);
  int last = 0;
  Origin origin;
  for (int i = 1; i < windows.count(); ++i) {
    Window& before = windows[last];
    const Window& window = windows[i];
    if (window.end <= before.end) {
      const double change = std::max(origin.change, excessOf(before, window));
      if (change <= mostChange) {
        if (origin.change == 0) origin.beginSlope = slopeAt(before, before.begin);
        origin.change = change;
        continue;
      }
    } else if (window.begin <= before.begin) {
      const double change = origin.change + excessOf(window, before);
      if (change <= mostChange) {
        before = window;
        origin = {change, slopeAt(window, window.begin)};
        continue;
      }
    } else if (join(before, window, mostChange, origin)) {
      continue;
    }
    windows[++last] = window;
    origin = {};
  }
  windows.resize(static_cast<size_t>(last + 1));
}

}  // namespace karcher

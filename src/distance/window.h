#pragma once

#include <algorithm>
#include <cstdint>

#include "mesh/rounding.h"
#include "mesh/types.h"

/// Windows on half-edges: see window_distance.h. In the frame of a half-edge its tail is the
/// origin, and its head lies on the positive x axis. The half-edge's face lies above the axis, and
/// the window's source below the axis.
namespace karcher {

struct Window {
  double begin = 0;  ///< the start of the interval, from the half-edge's tail
  double end = 0;
  double sourceX = 0;  ///< the source lies at (sourceX, -depth)
  double depth = 0;
  double offset = 0;      ///< the source's distance: 0 unless paths turn or windows were joined
  int pseudoSource = -1;  ///< the last vertex at which the paths turn, or -1
};

/// The most windows that a solver propagates, per face of the mesh. Ordinary meshes take 10 to 100;
/// only a surface whose shape is rounding noise comes near the limit.
inline constexpr int kMostWindowsPerFace = 10'000;

/// The least width of a window, also of a trimmed one, relative to its edge. The solver drops
/// narrower windows. Paths through their neighbours then reach the region behind them, with an
/// error of second order in this number.
inline constexpr double kNarrowestWindow = 1e-11;

/// The length of a path plus a rounding error. The path beats only paths longer than this sum.
inline double beatingLength(double length) { return length * (1 + kLocalRounding); }

inline double square(double x) { return x * x; }

/// The squared distance from the window's source to the point at x, without the offset.
inline double squaredLegTo(const Window& w, double x) {
  return square(x - w.sourceX) + square(w.depth);
}

/// The distance of the point at x, through the window.
inline double distanceAt(const Window& w, double x) {
  return w.offset + std::sqrt(squaredLegTo(w, x));
}

/// The least distance over the window.
inline double leastDistance(const Window& w) {
  return distanceAt(w, std::min(std::max(w.sourceX, w.begin), w.end));
}

/// The place where the half-edge meets the line from the window's source to a point above.
inline double crossingTowards(const Window& w, const Vec2& point) {
  return w.sourceX + (point.x() - w.sourceX) * w.depth / (w.depth + point.y());
}

/// The same window with the half-edge's head and tail exchanged. `length` is the length of the
/// half-edge.
inline Window mirrored(const Window& w, double length) {
  Window m = w;
  m.begin = length - w.end;
  m.end = length - w.begin;
  m.sourceX = length - w.sourceX;
  return m;
}

/// Removes the part of the interval where the path over the half-edge's tail and then along the
/// edge is shorter. Returns false if nothing remains.
inline bool trimByTail(Window& w, double tailDistance) {
  const double lead = beatingLength(tailDistance) - w.offset;
  const double leg = square(w.sourceX) + square(w.depth);
  if (lead >= 0 && square(lead) >= leg) return true;
  // This solves |x - source| = lead + x. The left side minus the right side falls with x. If the
  // equation is ill-conditioned, the two paths are almost equal over a long range, so that x may be
  // far off but the lengths at x are not.
  const double slope = 2 * (lead + w.sourceX);
  if (!(slope > 0)) return false;
  w.begin = std::max(w.begin, (leg - square(lead)) / slope);
  return w.begin < w.end;
}

/// The same for the path over the head.
inline bool trimByHead(Window& w, double headDistance, double length) {
  const double lead = beatingLength(headDistance) - w.offset;
  const double toSource = length - w.sourceX;
  const double leg = square(toSource) + square(w.depth);
  if (lead >= 0 && square(lead) >= leg) return true;
  const double slope = 2 * (lead + toSource);
  if (!(slope > 0)) return false;
  w.end = std::min(w.end, length - (leg - square(lead)) / slope);
  return w.begin < w.end;
}

inline bool isTooNarrow(const Window& w, double width) { return !(w.end - w.begin > width); }

/// The window after it crosses its face to the edge that leaves the half-edge's tail along the unit
/// vector `along`. The result is in the frame of that edge, with the same tail. `from` is the
/// length of the half-edge, and `length` that of the edge. The line from the source to the face's
/// apex crosses the half-edge at `apexCrossing`.
inline Window carriedToTailEdge(const Window& w, const Vec2& along, double from, double length,
                                double apexCrossing) {
  // Positions on an edge, and those of sources beside it, have rounding errors relative to its
  // length. If an end of a window lies within this rounding of the tail, or of the line to the
  // apex, it moves there. Otherwise a gap would remain there. On an edge much longer than the
  // distance of the source, the windows would then miss everything behind the gap.
  const double rounding = kStepRounding * from;
  const auto hit = [&](double x) {
    const double across = along.x() * w.depth - along.y() * (x - w.sourceX);
    return across > 0 ? std::min(x * w.depth / across, length) : length;
  };
  Window c = w;
  c.begin = w.begin > rounding ? hit(w.begin) : 0;
  c.end = w.end < apexCrossing - rounding ? hit(w.end) : length;
  c.sourceX = w.sourceX * along.x() - w.depth * along.y();
  c.depth = std::max(0.0, w.sourceX * along.y() + w.depth * along.x());
  return c;
}

/// Whether the vertex at (x, -depth) behind the window has shorter paths to all places that the
/// window reaches. `vertexDistance` is its distance. Every line from the window's source through
/// the window must cross the segment from the vertex to the window's end at `farEnd`.
inline bool isBeatenFrom(const Window& w, double vertexDistance, double x, double depth,
                         double farEnd) {
  const double lead = beatingLength(vertexDistance) - w.offset;
  return lead + std::sqrt(square(farEnd - x) + square(depth)) < std::sqrt(squaredLegTo(w, farEnd));
}

}  // namespace karcher

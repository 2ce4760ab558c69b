#include "intrinsic/strip_path.h"

#include <algorithm>

namespace karcher {
namespace {

using Portal = StripWorkspace::Portal;
using Bend = StripWorkspace::Bend;

/// A vertex with less surface than this on one side of the path lets it be shortened.
constexpr double kStraight = kPi - 1e-9;

bool touches(const TriangleMesh& mesh, int h, int vertex) {
  return mesh.tail(h) == vertex || mesh.head(h) == vertex;
}

/// True if the point lies on the edge of half-edge h.
bool liesOnEdge(const TriangleMesh& mesh, const PointLocation& point, int h) {
  if (point.simplex == Simplex::kVertex) return touches(mesh, h, point.vertex);
  return point.simplex == Simplex::kEdge &&
         (point.halfedge == h || (mesh.twin[h] >= 0 && point.halfedge == mesh.twin[h]));
}

/// One strip between two points, being pulled tight.
class Tightening {
 public:
  Tightening(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
             StripWorkspace& strip)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        from_(from),
        to_(to),
        fromLocation_(locate(mesh_, from)),
        toLocation_(locate(mesh_, to)),
        strip_(strip) {}

  void run() {
    // Each turn shortens the path; the bound is for angles that rounding cannot tell from pi.
    int turnsLeft = 64 + 16 * strip_.crossings.count();
    do {
      trimEnds();
      unfold();
      pullTight();
    } while (turnsLeft-- > 0 && turnRoundSharpestVertex());
  }

  double append(Array<SurfacePoint>& out) const;

 private:
  void trimEnds();
  void unfold();
  void pullTight();
  bool turnRoundSharpestVertex();

  int crossing(int i) const { return strip_.crossings[i]; }
  int crossingCount() const { return strip_.crossings.count(); }

  int vertexOf(const Bend& bend) const {
    const int h = crossing(bend.portal);
    return bend.onLeft ? mesh_.head(h) : mesh_.tail(h);
  }
  Vec2 positionOf(const Bend& bend) const {
    const Portal& portal = strip_.portals[bend.portal];
    return bend.onLeft ? portal.left : portal.right;
  }

  /// The portals around a bend's vertex: [first, last].
  struct Run {
    int first;
    int last;
  };
  Run runAround(const Bend& bend) const {
    const int vertex = vertexOf(bend);
    Run run{bend.portal, bend.portal};
    while (run.first > 0 && touches(mesh_, crossing(run.first - 1), vertex)) --run.first;
    while (run.last + 1 < crossingCount() && touches(mesh_, crossing(run.last + 1), vertex)) {
      ++run.last;
    }
    return run;
  }

  double angleInStrip(int bend) const;
  bool turnRound(const Bend& bend);

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SurfacePoint& from_;
  const SurfacePoint& to_;
  PointLocation fromLocation_;
  PointLocation toLocation_;
  StripWorkspace& strip_;
  Vec2 start_;  ///< from_, unfolded
  Vec2 end_;
};

/// Leaves out crossings of edges that an end point lies on: it lies in the face behind them too.
void Tightening::trimEnds() {
  Array<int>& crossings = strip_.crossings;
  int first = 0;
  while (first < crossings.count() && liesOnEdge(mesh_, fromLocation_, crossings[first])) {
    strip_.face = faceOf(mesh_.twin[crossings[first++]]);
  }
  int last = crossings.count();
  while (last > first && liesOnEdge(mesh_, toLocation_, crossings[last - 1])) --last;
  crossings.erase(crossings.begin() + last, crossings.end());
  crossings.erase(crossings.begin(), crossings.begin() + first);
}

/// Lays the strip's faces side by side in the frame of its first face.
void Tightening::unfold() {
  strip_.portals.clear();
  start_ = pointInFace(geometry_, inFace(mesh_, from_, strip_.face));
  if (crossingCount() == 0) {
    end_ = pointInFace(geometry_, inFace(mesh_, to_, strip_.face));
    return;
  }
  Vec2 right = cornerInFace(geometry_, strip_.face, cornerOf(crossing(0)));
  Vec2 left = cornerInFace(geometry_, strip_.face, cornerOf(next(crossing(0))));
  Vec2 apex = Vec2::Zero();
  for (int i = 0; i < crossingCount(); ++i) {
    if (i > 0) {
      // The strip leaves this face by one of the two edges that it did not enter by.
      if (crossing(i) == next(mesh_.twin[crossing(i - 1)])) {
        left = apex;
      } else {
        right = apex;
      }
    }
    strip_.portals.push_back({right, left});
    // The twin runs from left to right, and its opposite corner lies to the left of that.
    const int t = mesh_.twin[crossing(i)];
    const Vec2 along = (right - left) / geometry_.edgeLength[t];
    apex = left + rotate(along, oppositeOverHalfedge(geometry_, t));
  }
  const int t = mesh_.twin[crossing(crossingCount() - 1)];
  const SurfacePoint to = inFace(mesh_, to_, faceOf(t));
  end_ = to.bary[cornerOf(t)] * left + to.bary[cornerOf(next(t))] * right +
         to.bary[cornerOf(previous(t))] * apex;
}

/// The funnel: its apex is the last bend, its sides are the narrowest view through the portals.
void Tightening::pullTight() {
  const Array<Portal>& portals = strip_.portals;
  strip_.bends.clear();
  Vec2 apex = start_;
  Vec2 right = start_;
  Vec2 left = start_;
  int rightPortal = -1;
  int leftPortal = -1;
  for (int i = 0; i <= portals.count(); ++i) {
    const bool atEnd = i == portals.count();
    const Vec2 nextRight = atEnd ? end_ : portals[i].right;
    const Vec2 nextLeft = atEnd ? end_ : portals[i].left;
    const bool bendsLeft = cross(left - apex, nextRight - apex) > 0;
    const bool bendsRight = cross(right - apex, nextLeft - apex) < 0;
    if (bendsLeft || bendsRight) {
      const Bend bend = bendsLeft ? Bend{leftPortal, true} : Bend{rightPortal, false};
      strip_.bends.push_back(bend);
      apex = right = left = positionOf(bend);
      i = rightPortal = leftPortal = runAround(bend).last;
      continue;
    }
    if (cross(right - apex, nextRight - apex) >= 0) {
      right = nextRight;
      rightPortal = i;
    }
    if (cross(left - apex, nextLeft - apex) <= 0) {
      left = nextLeft;
      leftPortal = i;
    }
  }
}

/// The angle of the strip's surface between the two legs of the path at a bend, radians.
double Tightening::angleInStrip(int index) const {
  const Bend& bend = strip_.bends[index];
  const Run run = runAround(bend);
  const Vec2 at = positionOf(bend);
  const Vec2 before = index > 0 ? positionOf(strip_.bends[index - 1]) : start_;
  const Vec2 after = index + 1 < strip_.bends.count() ? positionOf(strip_.bends[index + 1]) : end_;
  const auto otherEnd = [&](int i) {
    return bend.onLeft ? strip_.portals[i].right : strip_.portals[i].left;
  };
  const auto angleBetween = [](const Vec2& a, const Vec2& b) {
    return std::atan2(std::abs(cross(a, b)), a.dot(b));
  };
  double angle = angleBetween(before - at, otherEnd(run.first) - at) +
                 angleBetween(after - at, otherEnd(run.last) - at);
  for (int i = run.first; i < run.last; ++i) {
    angle += angleBetween(otherEnd(i) - at, otherEnd(i + 1) - at);
  }
  return angle;
}

/// Leads the strip round the other side of a bend's vertex; false if the boundary is in the way.
bool Tightening::turnRound(const Bend& bend) {
  const Run run = runAround(bend);
  const int lastFace = faceOf(mesh_.twin[crossing(run.last)]);
  // The half-edge that leaves the vertex, in the strip's first face around it.
  int h = bend.onLeft ? next(crossing(run.first)) : crossing(run.first);
  strip_.turned.clear();
  while (faceOf(h) != lastFace) {
    // With the vertex on its left the strip turned counterclockwise: now it turns clockwise.
    const int out = bend.onLeft ? h : previous(h);
    const int t = mesh_.twin[out];
    if (t < 0) return false;
    strip_.turned.push_back(out);
    h = bend.onLeft ? next(t) : t;
  }
  Array<int>& crossings = strip_.crossings;
  // A strip that steps over an edge and straight back does neither.
  int first = run.first;
  int last = run.last + 1;
  auto turnedBegin = strip_.turned.begin();
  auto turnedEnd = strip_.turned.end();
  while (first > 0 && turnedBegin != turnedEnd &&
         crossings[first - 1] == mesh_.twin[*turnedBegin]) {
    --first;
    ++turnedBegin;
  }
  while (last < crossings.count() && turnedBegin != turnedEnd &&
         crossings[last] == mesh_.twin[*(turnedEnd - 1)]) {
    ++last;
    --turnedEnd;
  }
  while (turnedBegin == turnedEnd && first > 0 && last < crossings.count() &&
         crossings[first - 1] == mesh_.twin[crossings[last]]) {
    --first;
    ++last;
  }
  crossings.erase(crossings.begin() + first, crossings.begin() + last);
  crossings.insert(crossings.begin() + first, turnedBegin, turnedEnd);
  return true;
}

/// Turns the strip where the path bends most; false if the path is locally shortest.
bool Tightening::turnRoundSharpestVertex() {
  double sharpest = kStraight;
  int sharpestBend = -1;
  for (int i = 0; i < strip_.bends.count(); ++i) {
    const int vertex = vertexOf(strip_.bends[i]);
    if (mesh_.onBoundary[vertex]) continue;
    const double outside = geometry_.totalAngle[vertex] - angleInStrip(i);
    if (outside < sharpest) {
      sharpest = outside;
      sharpestBend = i;
    }
  }
  return sharpestBend >= 0 && turnRound(strip_.bends[sharpestBend]);
}

double Tightening::append(Array<SurfacePoint>& out) const {
  double length = 0;
  int lastVertex = fromLocation_.vertex;
  const auto appendVertex = [&](int h) {
    if (mesh_.tail(h) == lastVertex) return;
    lastVertex = mesh_.tail(h);
    out.push_back(edgePoint(h, 0));
  };
  Vec2 at = start_;
  int portal = 0;
  for (int leg = 0; leg <= strip_.bends.count(); ++leg) {
    const bool atEnd = leg == strip_.bends.count();
    const Vec2 to = atEnd ? end_ : positionOf(strip_.bends[leg]);
    const Run run = atEnd ? Run{crossingCount(), crossingCount()} : runAround(strip_.bends[leg]);
    const Vec2 along = to - at;
    for (; portal < run.first; ++portal) {
      const int h = crossing(portal);
      const Vec2& right = strip_.portals[portal].right;
      const Vec2 across = strip_.portals[portal].left - right;
      const double width = cross(along, across);
      const double s = width > 0 ? cross(along, at - right) / width : 0;
      if (s <= kVertexTolerance) {
        appendVertex(h);
      } else if (s >= 1 - kVertexTolerance) {
        appendVertex(next(h));
      } else {
        out.push_back(edgePoint(h, s));
        lastVertex = -1;
      }
    }
    length += along.norm();
    at = to;
    if (!atEnd) {
      const int h = crossing(run.first);
      appendVertex(strip_.bends[leg].onLeft ? next(h) : h);
      portal = run.last + 1;
    }
  }
  out.push_back(to_);
  return length;
}

}  // namespace

bool liesInFace(const TriangleMesh& mesh, const PointLocation& point, int f) {
  if (point.face == f) return true;
  if (point.simplex == Simplex::kEdge) {
    const int t = mesh.twin[point.halfedge];
    return t >= 0 && faceOf(t) == f;
  }
  return point.simplex == Simplex::kVertex &&
         (mesh.corner(f, 0) == point.vertex || mesh.corner(f, 1) == point.vertex ||
          mesh.corner(f, 2) == point.vertex);
}

int commonFace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const PointLocation onA = locate(mesh, a);
  const PointLocation onB = locate(mesh, b);
  if (onA.simplex != Simplex::kVertex) {
    if (liesInFace(mesh, onB, a.face)) return a.face;
    const int t = onA.simplex == Simplex::kEdge ? mesh.twin[onA.halfedge] : -1;
    return t >= 0 && liesInFace(mesh, onB, faceOf(t)) ? faceOf(t) : -1;
  }
  int h = mesh.outgoing[onA.vertex];
  do {
    if (liesInFace(mesh, onB, faceOf(h))) return faceOf(h);
    h = rotateLeft(mesh, h);
  } while (h >= 0 && h != mesh.outgoing[onA.vertex]);
  return -1;
}

double appendStripPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                       StripWorkspace& strip, Array<SurfacePoint>& out) {
  Tightening tightening(geometry, from, to, strip);
  tightening.run();
  return tightening.append(out);
}

}  // namespace karcher

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

/// The angle between two vectors, radians.
double angleBetween(const Vec2& a, const Vec2& b) {
  return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

/// Replaces the items [first, last) of an array.
void replaceItems(Array<int>& items, int first, int last, const int* begin, const int* end) {
  const auto count = static_cast<int>(end - begin);
  const int common = std::min(count, last - first);
  std::copy(begin, begin + common, items.begin() + first);
  if (common < count) items.insert(items.begin() + first + common, begin + common, end);
  if (common < last - first) items.erase(items.begin() + first + common, items.begin() + last);
}

/// One strip between two points, being pulled tight.
class Tightening {
 public:
  Tightening(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
             StripWorkspace& workspace)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        from_(from),
        to_(to),
        fromLocation_(locate(mesh_, from)),
        toLocation_(locate(mesh_, to)),
        workspace_(workspace),
        strip_(workspace.strip),
        bends_(workspace.bends) {}

  void run() {
    // Each turn shortens the path; the bound is for angles that rounding cannot tell from pi. A
    // strip around a corner passes over the vertices in between, up to a quarter of the square.
    const int64_t crossings = crossingCount();
    int64_t turnsLeft = 64 + 16 * crossings + crossings * crossings / 4;
    for (;;) {
      trimEnds();
      // The whole path in one frame, from which it is read.
      pullAllTight();
      int bend = sharpestBend();
      if (bend < 0 || turnsLeft <= 0) return;
      for (; bend >= 0 && turnsLeft > 0; --turnsLeft) {
        if (!turnRound(bend)) return;
        bend = sharpestBend();
      }
    }
  }

  double append(Array<SurfacePoint>& out) const;

 private:
  struct Trimmed {
    int front;
    int back;
  };
  Trimmed trimEnds();

  Vec2 unfold(int first, int last);
  Vec2 endBeyond(const Vec2& apex) const;
  void pullTight(int first, int last, const Vec2& start, const Vec2& end, Array<Bend>& bends);
  void measureBends(int first, int last, const Vec2& start, const Vec2& end, Array<Bend>& bends);
  void pullAllTight();
  void pullBetween(int before, int after);

  int sharpestBend() const;
  bool turnRound(int bend);
  void pullTightAround(int bend, int first, int last, int count);
  void updateOutside(Bend& bend);

  int crossing(int i) const { return strip_.crossings[i]; }
  int crossingCount() const { return strip_.crossings.count(); }

  int vertexOf(const Bend& bend) const {
    const int h = crossing(bend.portal);
    return bend.onLeft ? mesh_.head(h) : mesh_.tail(h);
  }
  Vec2 positionOf(const Bend& bend) const {
    const Portal& portal = workspace_.portals[bend.portal];
    return bend.onLeft ? portal.left : portal.right;
  }
  /// The other end of a portal that a bend's vertex is an end of.
  Vec2 acrossFrom(const Bend& bend, int portal) const {
    return bend.onLeft ? workspace_.portals[portal].right : workspace_.portals[portal].left;
  }
  /// The angle of the surface between the two legs of the path at a bend, in the strip.
  double angleInside(const Bend& bend) const {
    return geometry_.totalAngle[vertexOf(bend)] - bend.outside;
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

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SurfacePoint& from_;
  const SurfacePoint& to_;
  PointLocation fromLocation_;
  PointLocation toLocation_;
  StripWorkspace& workspace_;
  Strip& strip_;
  Array<Bend>& bends_;
  Vec2 start_;  ///< from_, unfolded by pullAllTight
  Vec2 end_;
};

/// Leaves out crossings of edges that an end point lies on: it lies in the face behind them too.
Tightening::Trimmed Tightening::trimEnds() {
  Array<int>& crossings = strip_.crossings;
  int first = 0;
  while (first < crossings.count() && liesOnEdge(mesh_, fromLocation_, crossings[first])) {
    strip_.face = faceOf(mesh_.twin[crossings[first++]]);
  }
  int last = crossings.count();
  while (last > first && liesOnEdge(mesh_, toLocation_, crossings[last - 1])) --last;
  const Trimmed trimmed{first, crossings.count() - last};
  crossings.erase(crossings.begin() + last, crossings.end());
  if (first > 0) crossings.erase(crossings.begin(), crossings.begin() + first);
  return trimmed;
}

/// Lays the faces from that before crossing `first` to that behind crossing `last` side by side, in
/// the frame of the first. Returns the corner of the last face opposite to the edge it is entered
/// by.
Vec2 Tightening::unfold(int first, int last) {
  if (workspace_.portals.count() < crossingCount()) {
    workspace_.portals.resize(static_cast<size_t>(crossingCount()));
  }
  const int h = crossing(first);
  Vec2 right = cornerInFace(geometry_, faceOf(h), cornerOf(h));
  Vec2 left = cornerInFace(geometry_, faceOf(h), cornerOf(next(h)));
  Vec2 apex = Vec2::Zero();
  for (int i = first; i <= last; ++i) {
    if (i > first) {
      // The strip leaves this face by one of the two edges that it did not enter by.
      if (crossing(i) == next(mesh_.twin[crossing(i - 1)])) {
        left = apex;
      } else {
        right = apex;
      }
    }
    workspace_.portals[i] = {right, left};
    // The twin runs from left to right, and its opposite corner lies to the left of that.
    const int t = mesh_.twin[crossing(i)];
    const Vec2 along = (right - left) / geometry_.edgeLength[t];
    apex = left + rotate(along, oppositeOverHalfedge(geometry_, t));
  }
  return apex;
}

/// The end of the path in the frame of an unfolding up to the last crossing, whose last corner is
/// `apex`.
Vec2 Tightening::endBeyond(const Vec2& apex) const {
  const Portal& portal = workspace_.portals[crossingCount() - 1];
  const int t = mesh_.twin[crossing(crossingCount() - 1)];
  const SurfacePoint to = inFace(mesh_, to_, faceOf(t));
  return to.bary[cornerOf(t)] * portal.left + to.bary[cornerOf(next(t))] * portal.right +
         to.bary[cornerOf(previous(t))] * apex;
}

/// The funnel through portals [first, last]: its apex is the last bend, its sides are the narrowest
/// view through the portals.
void Tightening::pullTight(int first, int last, const Vec2& start, const Vec2& end,
                           Array<Bend>& bends) {
  const Array<Portal>& portals = workspace_.portals;
  bends.clear();
  Vec2 apex = start;
  Vec2 right = start;
  Vec2 left = start;
  int rightPortal = -1;
  int leftPortal = -1;
  for (int i = first; i <= last + 1; ++i) {
    const bool atEnd = i == last + 1;
    const Vec2 nextRight = atEnd ? end : portals[i].right;
    const Vec2 nextLeft = atEnd ? end : portals[i].left;
    const bool bendsLeft = cross(left - apex, nextRight - apex) > 0;
    const bool bendsRight = cross(right - apex, nextLeft - apex) < 0;
    if (bendsLeft || bendsRight) {
      Bend bend;
      bend.portal = bendsLeft ? leftPortal : rightPortal;
      bend.onLeft = bendsLeft;
      bends.push_back(bend);
      apex = right = left = positionOf(bend);
      i = rightPortal = leftPortal = std::min(runAround(bend).last, last);
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
  measureBends(first, last, start, end, bends);
}

/// Measures the angles at the bends of a path through the unfolded portals [first, last].
void Tightening::measureBends(int first, int last, const Vec2& start, const Vec2& end,
                              Array<Bend>& bends) {
  Vec2 from = start;
  for (int i = 0; i < bends.count(); ++i) {
    Bend& bend = bends[i];
    const Vec2 at = positionOf(bend);
    const Vec2 to = i + 1 < bends.count() ? positionOf(bends[i + 1]) : end;
    const Run run = runAround(bend);
    // Where its edges are more than those in this frame, a leg runs along one of these.
    bend.before =
        run.first >= first ? angleBetween(from - at, acrossFrom(bend, run.first) - at) : 0;
    bend.after = run.last <= last ? angleBetween(to - at, acrossFrom(bend, run.last) - at) : 0;
    updateOutside(bend);
    from = at;
  }
}

/// A bend's angle on the side away from the strip, by those between its edges and to its legs.
void Tightening::updateOutside(Bend& bend) {
  const Run run = runAround(bend);
  double inside = bend.before + bend.after;
  for (int i = run.first + 1; i <= run.last; ++i) {
    const int h = crossing(i);
    inside += geometry_.cornerAngle[bend.onLeft ? next(h) : h];
  }
  bend.outside = geometry_.totalAngle[vertexOf(bend)] - inside;
}

void Tightening::pullAllTight() {
  const int last = crossingCount() - 1;
  bends_.clear();
  start_ = pointInFace(geometry_, inFace(mesh_, from_, strip_.face));
  if (last < 0) {
    end_ = pointInFace(geometry_, inFace(mesh_, to_, strip_.face));
    return;
  }
  end_ = endBeyond(unfold(0, last));
  pullTight(0, last, start_, end_, bends_);
}

/// Pulls the part between two bends tight (-1 for the start, one beyond the last for the end), in
/// a frame of its own: its bends are the workspace's new ones.
void Tightening::pullBetween(int before, int after) {
  Bend* const a = before >= 0 ? &bends_[before] : nullptr;
  Bend* const b = after < bends_.count() ? &bends_[after] : nullptr;
  const int first = a ? runAround(*a).last + 1 : 0;
  const int last = b ? runAround(*b).first - 1 : crossingCount() - 1;
  workspace_.newBends.clear();
  if (first <= last) {
    const Vec2 apex = unfold(first, last);
    const int face = faceOf(crossing(first));
    const Vec2 start = a ? cornerInFace(geometry_, face, cornerOf(previous(crossing(first))))
                         : pointInFace(geometry_, inFace(mesh_, from_, face));
    const Vec2 end = b ? apex : endBeyond(apex);
    pullTight(first, last, start, end, workspace_.newBends);
    const Array<Bend>& bends = workspace_.newBends;
    if (a) {
      const Vec2 to = bends.empty() ? end : positionOf(bends.front());
      a->after = angleBetween(to - start, acrossFrom(*a, first) - start);
    }
    if (b) {
      const Vec2 from = bends.empty() ? start : positionOf(bends.back());
      b->before = angleBetween(from - end, acrossFrom(*b, last) - end);
    }
  } else if (a && b) {
    // Along an edge of the mesh: the strip's side, or one that it crosses.
    const bool atSide = first == last + 1;
    const int h = atSide ? crossing(first) : -1;
    const auto cornerAt = [&](int vertex) {
      int corner = h;
      while (mesh_.tail(corner) != vertex) corner = next(corner);
      return geometry_.cornerAngle[corner];
    };
    a->after = atSide ? cornerAt(vertexOf(*a)) : 0;
    b->before = atSide ? cornerAt(vertexOf(*b)) : 0;
  } else if (a || b) {
    // In the strip's last or first face.
    Bend& bend = a ? *a : *b;
    const int h = a ? mesh_.twin[crossing(crossingCount() - 1)] : crossing(0);
    const int face = faceOf(h);
    const SurfacePoint point = inFace(mesh_, a ? to_ : from_, face);
    int corner = h;
    const bool atTail = a ? bend.onLeft : !bend.onLeft;
    if (!atTail) corner = next(h);
    const Vec2 at = cornerInFace(geometry_, face, cornerOf(corner));
    const Vec2 across = cornerInFace(geometry_, face, cornerOf(atTail ? next(h) : h));
    (a ? bend.after : bend.before) = angleBetween(pointInFace(geometry_, point) - at, across - at);
  }
  if (a) updateOutside(*a);
  if (b) updateOutside(*b);
}

/// The bend with the least angle outside, of those that let the path be shortened; or -1.
int Tightening::sharpestBend() const {
  double sharpest = kStraight;
  int found = -1;
  for (int i = 0; i < bends_.count(); ++i) {
    if (bends_[i].outside < sharpest && !mesh_.onBoundary[vertexOf(bends_[i])]) {
      sharpest = bends_[i].outside;
      found = i;
    }
  }
  return found;
}

/// Leads the strip round the other side of a bend's vertex and pulls the path tight there; false if
/// the boundary is in the way.
bool Tightening::turnRound(int index) {
  const Bend bend = bends_[index];
  const Run run = runAround(bend);
  const int lastFace = faceOf(mesh_.twin[crossing(run.last)]);
  // The half-edge that leaves the vertex, in the strip's first face around it.
  int h = bend.onLeft ? next(crossing(run.first)) : crossing(run.first);
  Array<int>& turned = workspace_.turned;
  turned.clear();
  while (faceOf(h) != lastFace) {
    // With the vertex on its left the strip turned counterclockwise: now it turns clockwise.
    const int out = bend.onLeft ? h : previous(h);
    const int t = mesh_.twin[out];
    if (t < 0) return false;
    turned.push_back(out);
    h = bend.onLeft ? next(t) : t;
  }
  Array<int>& crossings = strip_.crossings;
  // A strip that steps over an edge and straight back does neither.
  int first = run.first;
  int last = run.last + 1;
  const int* begin = turned.data();
  const int* end = begin + turned.count();
  while (first > 0 && begin != end && crossings[first - 1] == mesh_.twin[*begin]) {
    --first;
    ++begin;
  }
  while (last < crossings.count() && begin != end && crossings[last] == mesh_.twin[*(end - 1)]) {
    ++last;
    --end;
  }
  while (begin == end && first > 0 && last < crossings.count() &&
         crossings[first - 1] == mesh_.twin[crossings[last]]) {
    --first;
    ++last;
  }
  replaceItems(crossings, first, last, begin, end);
  pullTightAround(index, first, last, static_cast<int>(end - begin));
  return true;
}

/// Pulls the path tight where the crossings [first, last), those around a bend among them, were
/// replaced by `count` others. The bends before and after it stay if the path still turns that way.
void Tightening::pullTightAround(int bend, int first, int last, int count) {
  const Trimmed trimmed = trimEnds();
  int before = bend - 1;
  int after = bend + 1;
  while (before >= 0 && bends_[before].portal >= first) --before;
  while (after < bends_.count() && bends_[after].portal < last) ++after;
  // Near an end, everything up to it.
  if (trimmed.front > 0) before = -1;
  if (trimmed.back > 0) after = bends_.count();
  const int shift = count - (last - first) - trimmed.front;
  for (int i = after; i < bends_.count(); ++i) bends_[i].portal += shift;
  while (before >= 0 && bends_[before].portal >= crossingCount()) --before;
  while (after < bends_.count() && bends_[after].portal < 0) ++after;
  for (bool changed = true; changed;) {
    pullBetween(before, after);
    changed = false;
    if (before >= 0 && angleInside(bends_[before]) < kPi) {
      --before;
      changed = true;
    }
    if (after < bends_.count() && angleInside(bends_[after]) < kPi) {
      ++after;
      changed = true;
    }
  }
  const Array<Bend>& found = workspace_.newBends;
  const int common = std::min(found.count(), after - before - 1);
  const auto into = bends_.begin() + before + 1;
  std::copy(found.begin(), found.begin() + common, into);
  if (common < found.count()) {
    bends_.insert(into + common, found.begin() + common, found.end());
  } else {
    bends_.erase(into + common, bends_.begin() + after);
  }
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
  for (int leg = 0; leg <= bends_.count(); ++leg) {
    const bool atEnd = leg == bends_.count();
    const Vec2 to = atEnd ? end_ : positionOf(bends_[leg]);
    const Run run = atEnd ? Run{crossingCount(), crossingCount()} : runAround(bends_[leg]);
    const Vec2 along = to - at;
    for (; portal < run.first; ++portal) {
      const int h = crossing(portal);
      const Vec2& right = workspace_.portals[portal].right;
      const Vec2 across = workspace_.portals[portal].left - right;
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
      appendVertex(bends_[leg].onLeft ? next(h) : h);
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
  for (const int h : outgoingHalfedges(mesh, onA.vertex)) {
    if (liesInFace(mesh, onB, faceOf(h))) return faceOf(h);
  }
  return -1;
}

double appendStripPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                       StripWorkspace& workspace, Array<SurfacePoint>& out) {
  Tightening tightening(geometry, from, to, workspace);
  tightening.run();
  return tightening.append(out);
}

}  // namespace karcher

#include "intrinsic/tightening.h"

#include <algorithm>

#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Whether the point lies on the edge of half-edge h.
bool liesOnEdge(const TriangleMesh& mesh, const PointLocation& point, int h) {
  if (point.simplex == Simplex::kVertex) return touches(mesh, h, point.vertex);
  return point.simplex == Simplex::kEdge &&
         (point.halfedge == h || (mesh.twin[h] >= 0 && point.halfedge == mesh.twin[h]));
}

/// Replaces the items [first, last) of an array by the items [begin, end).
void replaceItems(Array<int>& items, int first, int last, const int* begin, const int* end) {
  const auto count = static_cast<int>(end - begin);
  const int common = std::min(count, last - first);
  std::copy(begin, begin + common, items.begin() + first);
  if (common < count) items.insert(items.begin() + first + common, begin + common, end);
  if (common < last - first) items.erase(items.begin() + first + common, items.begin() + last);
}

}  // namespace

/// Removes, at both ends of the strip, the crossings of edges on which the end point lies, since
/// the point also lies in the face behind them.
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

/// Unfolds the faces from the one before crossing `first` to the one after crossing `last`, in the
/// frame of the first face. Returns the corner of the last face opposite to the edge of crossing
/// `last`.
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
      // The strip leaves this face through one of the two edges by which it did not enter.
      if (crossing(i) == next(mesh_.twin[crossing(i - 1)])) {
        left = apex;
      } else {
        right = apex;
      }
    }
    workspace_.portals[i] = {right, left};
    // The twin leads from left to right, and its opposite corner lies to its left.
    const int t = mesh_.twin[crossing(i)];
    const Vec2 along = (right - left) / geometry_.edgeLength[t];
    apex = left + rotate(along, oppositeOverHalfedge(geometry_, t));
  }
  return apex;
}

/// The path's end, in the frame of an unfolding up to the last crossing. `apex` is the corner that
/// `unfold` returned.
Vec2 Tightening::endBeyond(const Vec2& apex) const {
  const Portal& portal = workspace_.portals[crossingCount() - 1];
  const int t = mesh_.twin[crossing(crossingCount() - 1)];
  const SurfacePoint to = inFace(mesh_, to_, faceOf(t));
  return to.bary[cornerOf(t)] * portal.left + to.bary[cornerOf(next(t))] * portal.right +
         to.bary[cornerOf(previous(t))] * apex;
}

/// Finds the bends of the tight path from `start` to `end` through portals [first, last], by a
/// funnel. The funnel's apex is the last bend; its sides bound the view through the portals.
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
    // If the strip also crosses edges of the bend's vertex outside this frame, the leg follows one
    // of these edges, and the angle is 0.
    bend.before =
        run.first >= first ? angleBetween(from - at, acrossFrom(bend, run.first) - at) : 0;
    bend.after = run.last <= last ? angleBetween(to - at, acrossFrom(bend, run.last) - at) : 0;
    bend.leg = (at - from).norm();
    updateOutside(bend);
    from = at;
  }
}

/// Updates the angle outside the strip at a bend: the vertex's total angle less all angles inside.
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
  } else {
    end_ = endBeyond(unfold(0, last));
    pullTight(0, last, start_, end_, bends_);
  }
  lastLeg_ = (end_ - (bends_.empty() ? start_ : positionOf(bends_.back()))).norm();
}

/// Pulls the part of the path between two bends tight, in a frame of its own. `before` is -1 for
/// the path's start, and `after` the number of bends for its end. Writes the bends of the part to
/// `newBends` of the workspace.
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
    const Vec2 from = bends.empty() ? start : positionOf(bends.back());
    if (b) b->before = angleBetween(from - end, acrossFrom(*b, last) - end);
    (b ? b->leg : lastLeg_) = (end - from).norm();
  } else if (a && b) {
    // The leg follows an edge of the mesh: a side of the strip, or an edge that the strip crosses.
    const bool atSide = first == last + 1;
    const int h = atSide ? crossing(first) : -1;
    const auto cornerAt = [&](int vertex) {
      int corner = h;
      while (mesh_.tail(corner) != vertex) corner = next(corner);
      return geometry_.cornerAngle[corner];
    };
    a->after = atSide ? cornerAt(vertexOf(*a)) : 0;
    b->before = atSide ? cornerAt(vertexOf(*b)) : 0;
    const int along = atSide ? (b->onLeft ? next(h) : previous(h)) : crossing(first - 1);
    b->leg = geometry_.edgeLength[along];
  } else if (a || b) {
    // The leg lies in the strip's last or first face.
    Bend& bend = a ? *a : *b;
    const int h = a ? mesh_.twin[crossing(crossingCount() - 1)] : crossing(0);
    const int face = faceOf(h);
    const SurfacePoint point = inFace(mesh_, a ? to_ : from_, face);
    int corner = h;
    const bool atTail = a ? bend.onLeft : !bend.onLeft;
    if (!atTail) corner = next(h);
    const Vec2 at = cornerInFace(geometry_, face, cornerOf(corner));
    const Vec2 across = cornerInFace(geometry_, face, cornerOf(atTail ? next(h) : h));
    const Vec2 leg = pointInFace(geometry_, point) - at;
    (a ? bend.after : bend.before) = angleBetween(leg, across - at);
    (a ? lastLeg_ : bend.leg) = leg.norm();
  } else {
    lastLeg_ = stepInFace(geometry_, strip_.face, from_, to_).norm();
  }
  if (a) updateOutside(*a);
  if (b) updateOutside(*b);
}

/// The bend with the least outside angle among those that allow shortening, or -1.
int Tightening::sharpestBend() const {
  double sharpest = kPi - kChainRounding;
  int found = -1;
  for (int i = 0; i < bends_.count(); ++i) {
    if (bends_[i].outside < sharpest && !mesh_.onBoundary[vertexOf(bends_[i])]) {
      sharpest = bends_[i].outside;
      found = i;
    }
  }
  return found;
}

/// Turns the strip at the sharpest bend until the path is locally shortest. Returns whether it
/// turned the strip.
bool Tightening::turnSharpBends() {
  bool turned = false;
  for (; turnsLeft_ > 0; --turnsLeft_) {
    const int bend = sharpestBend();
    if (bend < 0) break;
    const Bend sharpest = bends_[bend];
    if (!turnRound(sharpest, bend - 1, bend + 1)) break;
    turned = true;
  }
  return turned;
}

/// Leads the strip around the other side of a bend's vertex and pulls the path tight between the
/// two neighbouring bends. Returns false and changes nothing if the boundary is in the way.
bool Tightening::turnRound(const Bend& bend, int before, int after) {
  const Run run = runAround(bend);
  const int lastFace = faceOf(mesh_.twin[crossing(run.last)]);
  // The half-edge that leaves the vertex, in the first of the strip's faces around the vertex.
  int h = bend.onLeft ? next(crossing(run.first)) : crossing(run.first);
  Array<int>& turned = workspace_.turned;
  turned.clear();
  while (faceOf(h) != lastFace) {
    // With the vertex on its left the strip turned counterclockwise; now it turns clockwise.
    const int out = bend.onLeft ? h : previous(h);
    const int t = mesh_.twin[out];
    if (t < 0) return false;
    turned.push_back(out);
    h = bend.onLeft ? next(t) : t;
  }
  Array<int>& crossings = strip_.crossings;
  // Where the new strip would cross an edge and come straight back, it omits both crossings.
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
  pullTightAround(before, after, first, last, static_cast<int>(end - begin));
  return true;
}

/// Pulls the path tight after `count` crossings have replaced [first, last) between two bends. A
/// bend next to the new part stays only if the path still turns there in the same direction.
void Tightening::pullTightAround(int before, int after, int first, int last, int count) {
  const Trimmed trimmed = trimEnds();
  while (before >= 0 && bends_[before].portal >= first) --before;
  while (after < bends_.count() && bends_[after].portal < last) ++after;
  // If crossings at an end were removed, the whole part up to that end is pulled tight.
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
  const auto into = bends_.begin() + (before + 1);
  std::copy(found.begin(), found.begin() + common, into);
  if (common < found.count()) {
    bends_.insert(into + common, found.begin() + common, found.end());
  } else {
    bends_.erase(into + common, bends_.begin() + after);
  }
}

}  // namespace karcher

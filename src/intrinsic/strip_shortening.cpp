#include <algorithm>

#include "intrinsic/tightening.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The largest number of vertices beside a leg that the search tries. It begins with the greatest
/// gain.
constexpr int kPassages = 4;

}  // namespace

double Tightening::length() const {
  double sum = lastLeg_;
  for (const Bend& bend : bends_) sum += bend.leg;
  return sum;
}

/// Leads the strip over vertices beside the path where this shortens the path. If a vertex has an
/// angle of less than 2 pi, paths on both of its sides can be locally shortest. On a cone, the
/// shorter path is on the side where the leg's ends span the smaller angle at the vertex.
void Tightening::passOverVertices() {
  passagesLeft_ = 64 + 4 * crossingCount();
  for (int leg = 0; leg <= bends_.count() && passagesLeft_ > 0;) {
    leg = shortenLeg(leg) ? std::max(0, leg - 1) : leg + 1;
  }
}

/// Tries to shorten one straight piece of the path.
bool Tightening::shortenLeg(int leg) {
  const int first = leg > 0 ? runAround(bends_[leg - 1]).last + 1 : 0;
  const int last = leg < bends_.count() ? runAround(bends_[leg]).first - 1 : crossingCount() - 1;
  if (first > last) return false;
  const Vec2 apex = unfold(first, last);
  const int h = crossing(first);
  const Vec2 start = leg > 0 ? cornerInFace(geometry_, faceOf(h), cornerOf(previous(h)))
                             : pointInFace(geometry_, inFace(mesh_, from_, faceOf(h)));
  const Vec2 end = leg < bends_.count() ? apex : endBeyond(apex);
  const double straight = (end - start).norm();
  Array<Passage>& passages = workspace_.passages;
  passages.clear();
  const auto consider = [&](int portal, bool onLeft) {
    const Bend place{.portal = portal, .onLeft = onLeft};
    const int vertex = vertexOf(place);
    const double total = geometry_.totalAngle[vertex];
    if (total >= 2 * kPi || mesh_.onBoundary[vertex]) return;
    const Vec2 at = positionOf(place);
    const Vec2 back = start - at;
    const Vec2 on = end - at;
    const double inside = angleBetween(back, on);
    if (total >= 2 * inside) return;
    const double across =
        std::sqrt(std::max(0.0, back.squaredNorm() + on.squaredNorm() -
                                    2 * back.norm() * on.norm() * std::cos(total - inside)));
    const double gain = straight - across;
    if (gain > kChainRounding * straight) passages.push_back({portal, onLeft, gain});
  };
  for (int i = first; i <= last; ++i) {
    const bool leftIsNew = i == first || crossing(i) == next(mesh_.twin[crossing(i - 1)]);
    const bool rightIsNew = i == first || !leftIsNew;
    if (leftIsNew) consider(i, true);
    if (rightIsNew) consider(i, false);
  }
  for (int i = 0; i < std::min(passages.count(), kPassages); ++i) {
    if (passagesLeft_-- <= 0) return false;
    // Moves the passage with the greatest remaining gain to place i.
    std::iter_swap(passages.begin() + i, std::max_element(passages.begin() + i, passages.end(),
                                                          [](const Passage& a, const Passage& b) {
                                                            return a.gain < b.gain;
                                                          }));
    if (passOver(passages[i], leg)) return true;
  }
  return false;
}

/// Leads the strip over a vertex beside one of its legs, if this makes the path shorter.
bool Tightening::passOver(const Passage& passage, int leg) {
  const double before = length();
  const double lastLeg = lastLeg_;
  workspace_.keptStrip.face = strip_.face;
  workspace_.keptStrip.crossings.assign(strip_.crossings.begin(), strip_.crossings.end());
  workspace_.keptBends.assign(bends_.begin(), bends_.end());
  turnRound({.portal = passage.portal, .onLeft = passage.onLeft}, leg - 1, leg);
  turnSharpBends();
  if (length() < before * (1 - kChainRounding)) return true;
  strip_.face = workspace_.keptStrip.face;
  strip_.crossings.swap(workspace_.keptStrip.crossings);
  bends_.swap(workspace_.keptBends);
  lastLeg_ = lastLeg;
  return false;
}

}  // namespace karcher

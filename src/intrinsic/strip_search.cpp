#include "intrinsic/strip_search.h"

#include <algorithm>

#include "intrinsic/strip_path.h"

namespace karcher {
namespace {

using Node = StripSearchWorkspace::Node;
using QueueEntry = StripSearchWorkspace::QueueEntry;

/// The point of the edge a-b nearest to the line through p and q, but at least 1 % of the edge away
/// from its ends; the midpoint if the edge and the line are parallel.
Vec3 entryPoint(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
  const Vec3 d = q - p;
  const Vec3 e = b - a;
  const Vec3 w = a - p;
  const double dd = d.squaredNorm();
  const double de = d.dot(e);
  const double determinant = dd * e.squaredNorm() - de * de;
  const double s = (de * d.dot(w) - dd * e.dot(w)) / determinant;
  return a + (determinant > 0 ? std::clamp(s, 0.01, 0.99) : 0.5) * e;
}

/// The A* search over faces.
class StripSearch {
 public:
  StripSearch(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
              const StripSearchOptions& options, StripSearchWorkspace& workspace)
      : mesh_(mesh),
        toLocation_(locate(mesh, to)),
        target_(position(mesh, to)),
        workspace_(workspace),
        maxFaces_(options.maxFaces),
        weight_(options.weight) {
    workspace_.nodes.clear();
    workspace_.queue.clear();
    workspace_.nodeOf.clear();
    if (options.firstFace >= 0) {
      reach(options.firstFace, -1, 0, position(mesh, from));
    } else {
      start(from);
    }
  }

  bool run(Strip& strip) {
    // The search expands each face once, and queues it at most once for each of its edges.
    while (found_ < 0 && !workspace_.queue.empty()) {
      std::pop_heap(workspace_.queue.begin(), workspace_.queue.end(), later);
      const QueueEntry top = workspace_.queue.back();
      workspace_.queue.pop_back();
      if (workspace_.nodes[top.node].expanded) continue;
      workspace_.nodes[top.node].expanded = true;
      const Node node = workspace_.nodes[top.node];
      if (liesInFace(mesh_, toLocation_, node.face)) {
        found_ = top.node;
        break;
      }
      if (workspace_.nodes.count() > maxFaces_) return false;
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * node.face + k;
        const int t = mesh_.twin[h];
        if (t < 0 || t == node.enteredBy || isExpanded(faceOf(t))) continue;
        const Vec3 entry = entryPoint(mesh_.positions[mesh_.tail(h)],
                                      mesh_.positions[mesh_.head(h)], node.entry, target_);
        reach(faceOf(t), h, node.length + (entry - node.entry).norm(), entry);
      }
    }
    if (found_ < 0) return false;
    strip.crossings.clear();
    int node = found_;
    while (workspace_.nodes[node].enteredBy >= 0) {
      const int h = workspace_.nodes[node].enteredBy;
      strip.crossings.push_back(h);
      node = workspace_.nodeOf.find(faceOf(h));
    }
    strip.face = workspace_.nodes[node].face;
    std::reverse(strip.crossings.begin(), strip.crossings.end());
    return true;
  }

 private:
  static bool later(const QueueEntry& a, const QueueEntry& b) { return a.key > b.key; }

  void start(const SurfacePoint& from) {
    const Vec3 entry = position(mesh_, from);
    const PointLocation location = locate(mesh_, from);
    if (location.simplex != Simplex::kVertex) {
      reach(from.face, -1, 0, entry);
      const int t = location.simplex == Simplex::kEdge ? mesh_.twin[location.halfedge] : -1;
      if (t >= 0) reach(faceOf(t), -1, 0, entry);
      return;
    }
    for (const int h : outgoingHalfedges(mesh_, location.vertex)) {
      reach(faceOf(h), -1, 0, entry);
    }
  }

  /// Queues a face if this path to it is the shortest so far.
  void reach(int face, int enteredBy, double length, const Vec3& entry) {
    int number = workspace_.nodeOf.find(face);
    if (number < 0) {
      number = workspace_.nodes.count();
      workspace_.nodeOf.add(face);
      workspace_.nodes.push_back({face, enteredBy, false, length, entry});
    } else {
      Node& node = workspace_.nodes[number];
      if (node.expanded || !(length < node.length)) return;
      node = {face, enteredBy, false, length, entry};
    }
    workspace_.queue.push_back({length + weight_ * (target_ - entry).norm(), number});
    std::push_heap(workspace_.queue.begin(), workspace_.queue.end(), later);
  }

  bool isExpanded(int face) const {
    const int number = workspace_.nodeOf.find(face);
    return number >= 0 && workspace_.nodes[number].expanded;
  }

  const TriangleMesh& mesh_;
  PointLocation toLocation_;
  Vec3 target_;
  StripSearchWorkspace& workspace_;
  int maxFaces_;
  double weight_;
  int found_ = -1;
};

}  // namespace

bool searchStrip(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                 const StripSearchOptions& options, StripSearchWorkspace& workspace, Strip& strip) {
  return StripSearch(mesh, from, to, options, workspace).run(strip);
}

}  // namespace karcher

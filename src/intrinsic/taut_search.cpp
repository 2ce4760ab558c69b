#include "intrinsic/taut_search.h"

#include <algorithm>

#include "intrinsic/strip_path.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

using TautNode = TautSearchWorkspace::Node;
using TautEntry = TautSearchWorkspace::QueueEntry;

/// Lengths are measured to a point of an edge that is at least this far from the edge's ends,
/// relative to the edge.
constexpr double kOffVertices = 0.01;

bool isLater(const TautEntry& a, const TautEntry& b) { return a.key > b.key; }

/// The view of a node: the source, and the vertices at the sides of the view.
struct View {
  double base;
  Vec2 source;
  Vec2 left;
  Vec2 right;
};

class TautSearch {
 public:
  TautSearch(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
             TautSearchWorkspace& workspace)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        from_(from),
        to_(to),
        fromLocation_(locate(mesh_, from)),
        toLocation_(locate(mesh_, to)),
        target_(position(mesh_, to)),
        workspace_(workspace) {
    workspace_.nodes.clear();
    workspace_.queue.clear();
    workspace_.nodeOf.clear();
  }

  bool run(Strip& strip) {
    start();
    Array<TautEntry>& queue = workspace_.queue;
    // The search expands each half-edge once, and queues it at most twice.
    while (!queue.empty()) {
      std::pop_heap(queue.begin(), queue.end(), isLater);
      const TautEntry first = queue.back();
      queue.pop_back();
      if (first.node < 0) {
        write(-1 - first.node, strip);
        return true;
      }
      if (workspace_.nodes[first.node].expanded) continue;
      workspace_.nodes[first.node].expanded = true;
      expand(first.node);
    }
    return false;
  }

 private:
  void start() {
    if (fromLocation_.simplex == Simplex::kVertex) {
      int h = mesh_.outgoing[fromLocation_.vertex];
      do {
        leave(next(h));
        h = rotateLeft(mesh_, h);
      } while (h >= 0 && h != mesh_.outgoing[fromLocation_.vertex]);
      return;
    }
    const int onEdge = fromLocation_.simplex == Simplex::kEdge ? fromLocation_.halfedge : -1;
    for (int h = 3 * from_.face; h < 3 * from_.face + 3; ++h) {
      if (h != onEdge) leave(h);
    }
    const int twin = onEdge >= 0 ? mesh_.twin[onEdge] : -1;
    if (twin < 0) return;
    leave(next(twin));
    leave(previous(twin));
  }

  /// Leaves one of the start's faces across a half-edge.
  void leave(int h) {
    if (mesh_.twin[h] < 0) return;
    const int face = faceOf(h);
    const double edge = geometry_.edgeLength[h];
    const Vec2 origin = cornerInFace(geometry_, face, cornerOf(next(h)));
    const Vec2 along = (cornerInFace(geometry_, face, cornerOf(h)) - origin) / edge;
    const Vec2 source = pointInFace(geometry_, inFace(mesh_, from_, face));
    reach(mesh_.twin[h], -1, position(mesh_, from_),
          {0, rotateBack(along, source - origin), Vec2::Zero(), Vec2(edge, 0)});
  }

  void expand(int number) {
    // This is a copy, since new nodes may move the others.
    const TautNode node = workspace_.nodes[number];
    const int h = node.halfedge;
    const Vec2 apex = oppositeOverHalfedge(geometry_, h);
    const Vec2 head(geometry_.edgeLength[h], 0);
    if (liesInFace(mesh_, toLocation_, faceOf(h))) {
      const SurfacePoint to = inFace(mesh_, to_, faceOf(h));
      enqueue({lengthTo(node,
                        to.bary[cornerOf(next(h))] * head + to.bary[cornerOf(previous(h))] * apex),
               -1 - number});
    }
    // Seen from the source the apex lies left of the view, in it, or right of it.
    const bool isLeft = cross(node.left - node.source, apex - node.source) >= 0;
    const bool isRight = cross(node.right - node.source, apex - node.source) <= 0;
    const int onRight = mesh_.twin[next(h)];
    if (onRight >= 0) {
      const double edge = geometry_.edgeLength[onRight];
      const Vec2 along = (head - apex) / edge;
      const auto seen = [&](const Vec2& x) { return rotateBack(along, x - apex); };
      if (isRight) {
        reach(onRight, number, node.entry,
              {node.base + (node.right - node.source).norm(), seen(node.right), Vec2::Zero(),
               Vec2(edge, 0)});
      } else {
        reach(onRight, number, node.entry,
              {node.base, seen(node.source), isLeft ? seen(node.left) : Vec2(0, 0),
               seen(node.right)});
      }
    }
    const int onLeft = mesh_.twin[previous(h)];
    if (onLeft >= 0) {
      const double edge = geometry_.edgeLength[onLeft];
      const Vec2 along = apex / edge;
      const auto seen = [&](const Vec2& x) { return rotateBack(along, x); };
      if (isLeft) {
        reach(onLeft, number, node.entry,
              {node.base + (node.left - node.source).norm(), seen(node.left), Vec2::Zero(),
               Vec2(edge, 0)});
      } else {
        reach(onLeft, number, node.entry,
              {node.base, seen(node.source), seen(node.left),
               isRight ? seen(node.right) : Vec2(edge, 0)});
      }
    }
  }

  /// The length of the path to a point beyond the node's edge.
  static double lengthTo(const TautNode& node, const Vec2& point) {
    const bool isLeft = cross(node.left - node.source, point - node.source) > 0;
    const bool isRight = cross(node.right - node.source, point - node.source) < 0;
    if (!isLeft && !isRight) return node.base + (point - node.source).norm();
    const Vec2& bend = isLeft ? node.left : node.right;
    return node.base + (bend - node.source).norm() + (point - bend).norm();
  }

  /// Queues a half-edge if this path through it is the shortest so far.
  void reach(int h, int before, const Vec3& last, const View& view) {
    const int number = workspace_.nodeOf.find(h);
    if (number >= 0 && workspace_.nodes[number].expanded) return;
    const double edge = geometry_.edgeLength[h];
    // The places where the rays through the sides of the view meet the edge.
    const auto meet = [&](const Vec2& side, double otherwise) {
      const double rise = side.y() - view.source.y();
      if (rise <= kLocalRounding * edge) return otherwise;
      return view.source.x() - (side.x() - view.source.x()) * view.source.y() / rise;
    };
    const double low = std::clamp(meet(view.left, 0), 0.0, edge);
    const double high = std::clamp(meet(view.right, edge), low, edge);
    // The point of the edge, within the view, that is nearest to the line from the last point to
    // the target.
    const Vec3& tail = mesh_.positions[mesh_.tail(h)];
    const Vec3 along = mesh_.positions[mesh_.head(h)] - tail;
    const Vec3 on = target_ - last;
    const Vec3 back = tail - last;
    const double onOn = on.squaredNorm();
    const double onAlong = on.dot(along);
    const double determinant = onOn * along.squaredNorm() - onAlong * onAlong;
    const double part =
        determinant > 0 ? (onAlong * on.dot(back) - onOn * along.dot(back)) / determinant : 0.5;
    const double at = std::clamp(std::clamp(part * edge, low, high), kOffVertices * edge,
                                 (1 - kOffVertices) * edge);
    const Vec3 entry = tail + at / edge * along;
    const double key = view.base + (Vec2(at, 0) - view.source).norm() + (target_ - entry).norm();
    const TautNode node{h,           before,    false,      key,  view.base,
                        view.source, view.left, view.right, entry};
    if (number < 0) {
      workspace_.nodeOf.add(h);
      enqueue({key, workspace_.nodes.count()});
      workspace_.nodes.push_back(node);
    } else if (key < workspace_.nodes[number].key) {
      enqueue({key, number});
      workspace_.nodes[number] = node;
    }
  }

  void enqueue(const TautEntry& entry) {
    workspace_.queue.push_back(entry);
    std::push_heap(workspace_.queue.begin(), workspace_.queue.end(), isLater);
  }

  void write(int node, Strip& strip) const {
    strip.crossings.clear();
    for (; node >= 0; node = workspace_.nodes[node].before) {
      strip.crossings.push_back(mesh_.twin[workspace_.nodes[node].halfedge]);
    }
    std::reverse(strip.crossings.begin(), strip.crossings.end());
    strip.face = faceOf(strip.crossings.front());
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SurfacePoint& from_;
  const SurfacePoint& to_;
  PointLocation fromLocation_;
  PointLocation toLocation_;
  Vec3 target_;
  TautSearchWorkspace& workspace_;
};

}  // namespace

bool searchTautStrip(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     TautSearchWorkspace& workspace, Strip& strip) {
  return TautSearch(geometry, from, to, workspace).run(strip);
}

}  // namespace karcher

#pragma once

#include <utility>

#include "mesh/types.h"

/// A search for the item in space nearest to a place: a tree of boxes around the items, which opens
/// only boxes that may contain a nearer one.
namespace karcher {

struct Box {
  Vec3 low = Vec3::Constant(kInfinity);
  Vec3 high = Vec3::Constant(-kInfinity);

  void include(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void include(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  double squaredDistance(const Vec3& q) const {
    return (low - q).cwiseMax(q - high).cwiseMax(0).squaredNorm();
  }
};

class BoxTree {
 public:
  /// The items have one box each.
  explicit BoxTree(const Array<Box>& boxes);

  struct Nearest {
    int item = -1;
    double squaredDistance = kInfinity;
  };

  /// The nearest item, or `best`, the result so far, if no item is nearer. `squaredDistance`
  /// returns the squared distance between an item, by its index, and q.
  template <class SquaredDistance>
  Nearest nearest(const Vec3& q, const SquaredDistance& squaredDistance, Nearest best) const {
    open(0, nodes_[0].box.squaredDistance(q), q, squaredDistance, best);
    return best;
  }
  template <class SquaredDistance>
  Nearest nearest(const Vec3& q, const SquaredDistance& squaredDistance) const {
    return nearest(q, squaredDistance, Nearest());
  }

 private:
  /// A node, whose first child is the next one.
  struct Node {
    Box box;
    int second = -1;  // the second child; -1 at a leaf
    int from = 0;     // first item of a leaf
    int to = 0;
  };

  int build(const Array<Box>& boxes, int from, int to);

  template <class SquaredDistance>
  void open(int number, double distance, const Vec3& q, const SquaredDistance& squaredDistance,
            Nearest& best) const {
    if (distance >= best.squaredDistance) return;
    const Node& node = nodes_[number];
    if (node.second < 0) {
      for (int i = node.from; i < node.to; ++i) {
        const double squared = squaredDistance(items_[i], q);
        if (squared < best.squaredDistance) best = {items_[i], squared};
      }
      return;
    }
    std::pair<int, double> near{number + 1, nodes_[number + 1].box.squaredDistance(q)};
    std::pair<int, double> far{node.second, nodes_[node.second].box.squaredDistance(q)};
    if (far.second < near.second) std::swap(near, far);
    open(near.first, near.second, q, squaredDistance, best);
    open(far.first, far.second, q, squaredDistance, best);
  }

  Array<Node> nodes_;
  Array<int> items_;
};

}  // namespace karcher

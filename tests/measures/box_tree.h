#pragma once

#include <utility>

#include "mesh/types.h"

/// Which of many things in space is nearest to a place: a tree of boxes around them, of which only
/// those are opened that may hold something nearer than what was found.
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
  /// One box an item.
  explicit BoxTree(const Array<Box>& boxes);

  struct Nearest {
    int item = -1;
    double squaredDistance = kInfinity;
  };

  /// `squaredDistance` of an item's number and q gives the squared distance between them. `best`
  /// is what is known already; it is returned where nothing is nearer.
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
  /// Its first child is the next node.
  struct Node {
    Box box;
    int second = -1;  ///< child; -1 at a leaf
    int from = 0;     ///< of a leaf's items
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

#include "measures/box_tree.h"

#include <algorithm>
#include <numeric>

namespace karcher {
namespace {

constexpr int kLeafItems = 4;

}  // namespace

BoxTree::BoxTree(const Array<Box>& boxes) {
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  build(boxes, 0, boxes.count());
}

/// Splits the items at the median of their middles, along the longest side of the box of these
/// middles.
int BoxTree::build(const Array<Box>& boxes, int from, int to) {
  const int number = nodes_.count();
  nodes_.emplace_back();
  Node node{{}, -1, from, to};
  Box middles;
  for (int i = from; i < to; ++i) {
    node.box.include(boxes[items_[i]]);
    middles.include(Vec3((boxes[items_[i]].low + boxes[items_[i]].high) / 2));
  }
  if (to - from > kLeafItems) {
    int axis = 0;
    (middles.high - middles.low).maxCoeff(&axis);
    const int half = from + (to - from) / 2;
    std::nth_element(items_.begin() + from, items_.begin() + half, items_.begin() + to,
                     [&](int a, int b) {
                       return boxes[a].low[axis] + boxes[a].high[axis] <
                              boxes[b].low[axis] + boxes[b].high[axis];
                     });
    build(boxes, from, half);
    node.second = build(boxes, half, to);
  }
  nodes_[number] = node;
  return number;
}

}  // namespace karcher

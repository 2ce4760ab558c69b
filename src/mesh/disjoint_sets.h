#pragma once

#include <algorithm>
#include <numeric>

#include "mesh/types.h"

namespace karcher {

/// Disjoint sets of numbers, each named by its smallest number (R. Tarjan, 1975; with path
/// halving).
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int find(int v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  /// Unites the sets of two numbers. Returns false if both numbers already were in the same set.
  bool unite(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

  /// For each number, the smallest number of its set.
  Array<int> names() {
    Array<int> result(parent_.size());
    for (int v = 0; v < result.count(); ++v) result[v] = find(v);
    return result;
  }

 private:
  Array<int> parent_;
};

/// Disjoint sets of faces whose orientations relative to each other are known.
class OrientedSets {
 public:
  explicit OrientedSets(int count)
      : parent_(static_cast<size_t>(count)), turned_(static_cast<size_t>(count), 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  struct Place {
    int set;      ///< the set, named by one of its faces
    bool turned;  ///< whether the face is turned relative to the face that names the set
  };

  Place find(int f) {
    int root = f;
    bool turned = false;
    while (parent_[root] != root) {
      turned ^= turned_[root] != 0;
      root = parent_[root];
    }
    const Place place{root, turned};
    // Path compression: the root becomes the parent of every face on the path.
    while (f != root) {
      const int up = parent_[f];
      const bool own = turned_[f] != 0;
      parent_[f] = root;
      turned_[f] = turned ? 1 : 0;
      turned ^= own;
      f = up;
    }
    return place;
  }

  /// Joins the sets of two adjacent faces; `turned` is true if their orientations differ. Returns
  /// false and changes nothing if the faces are already joined with the opposite relation.
  bool unite(int f, int g, bool turned) {
    const Place a = find(f);
    const Place b = find(g);
    if (a.set == b.set) return (a.turned != b.turned) == turned;
    const int low = std::min(a.set, b.set);
    const int high = std::max(a.set, b.set);
    parent_[high] = low;
    turned_[high] = (a.turned != b.turned) != turned ? 1 : 0;
    return true;
  }

 private:
  Array<int> parent_;
  Array<uint8_t> turned_;  ///< whether each face is turned relative to its parent
};

}  // namespace karcher

#pragma once

#include <algorithm>

#include "mesh/types.h"

namespace karcher {

/// A priority queue for keys >= 0 that rise slowly: items wait in buckets of equal width, and a
/// bucket is sorted when its turn comes. Items come out in the order of their keys, as floats, and
/// of their numbers where keys are equal; a key below those that came out already comes next.
class OrderedQueue {
 public:
  explicit OrderedQueue(double width)
      : inverseWidth_(1 / width), buckets_(static_cast<size_t>(kBuckets)) {}

  struct Entry {
    float key = 0;
    int item = 0;
    bool operator<(const Entry& other) const {
      return key < other.key || (key == other.key && item < other.item);
    }
  };

  void push(double key, int item) {
    const Entry entry{static_cast<float>(key), item};
    const int64_t bucket = place(key);
    if (bucket <= current_) {
      open_.insert(std::upper_bound(open_.begin() + next_, open_.end(), entry), entry);
    } else if (bucket < current_ + kBuckets) {
      buckets_[bucket & kMask].push_back(entry);
    } else {
      far_.push_back(entry);
    }
    ++count_;
  }

  bool empty() const { return count_ == 0; }

  /// The queue must not be empty.
  Entry pop() {
    while (next_ == open_.count()) openNext();
    --count_;
    return open_[next_++];
  }

  /// Costs the buckets and what still waits.
  void clear() {
    for (Array<Entry>& bucket : buckets_) bucket.clear();
    open_.clear();
    far_.clear();
    current_ = 0;
    next_ = 0;
    count_ = 0;
  }

 private:
  static constexpr int kBuckets = 512;
  static constexpr int64_t kMask = kBuckets - 1;

  int64_t place(double key) const { return static_cast<int64_t>(key * inverseWidth_); }

  void openNext() {
    ++current_;
    if (count_ == static_cast<int64_t>(far_.size())) {
      // Only far entries wait: no need to look into every bucket on the way.
      current_ = std::max(current_, place(std::min_element(far_.begin(), far_.end())->key));
      takeFromFar();
    } else if ((current_ & kMask) == 0 && !far_.empty()) {
      takeFromFar();
    }
    open_.clear();
    next_ = 0;
    std::swap(open_, buckets_[current_ & kMask]);
    std::sort(open_.begin(), open_.end());
  }

  /// Once a round of the ring: puts into their buckets the far entries that the next rounds reach.
  void takeFromFar() {
    Array<Entry> kept;
    for (const Entry& entry : far_) {
      const int64_t bucket = std::max(place(entry.key), current_);
      if (bucket < current_ + kBuckets) {
        buckets_[bucket & kMask].push_back(entry);
      } else {
        kept.push_back(entry);
      }
    }
    far_ = std::move(kept);
  }

  double inverseWidth_;
  Array<Array<Entry>> buckets_;
  Array<Entry> open_;  ///< the bucket whose turn it is, sorted from `next_` on
  Array<Entry> far_;   ///< entries beyond the ring
  int64_t current_ = 0;
  int next_ = 0;
  int64_t count_ = 0;
};

}  // namespace karcher

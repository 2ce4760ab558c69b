#pragma once

#include <algorithm>

#include "mesh/types.h"

namespace karcher {

/// A queue of items with keys >= 0, in buckets of equal width. Items leave bucket by bucket in the
/// order of their keys; within a bucket, they leave first in, first out. An item may enter the
/// bucket that `pop` is emptying. The number of buckets is fixed: an item whose key lies beyond the
/// last bucket leaves early, never late.
class BucketQueue {
 public:
  explicit BucketQueue(double width)
      : width_(width), inverseWidth_(1 / width), buckets_(static_cast<size_t>(kBuckets)) {}

  /// The bucket of a key, at least the current one and at most the last one.
  int bucketOf(double key) const {
    const int last = current_ + kBuckets - 1;
    const double bucket = key * inverseWidth_;
    return bucket < last ? std::max(static_cast<int>(bucket), current_) : last;
  }

  void push(int item, int bucket) {
    buckets_[bucket & (kBuckets - 1)].push_back(item);
    ++count_;
  }

  bool empty() const { return count_ == 0; }

  /// The bucket that `pop` is emptying.
  int current() const { return current_; }
  /// The least key that an item may still have.
  double leastKey() const { return current_ * width_; }

  /// Removes the next item and returns true. Returns false if the queue is empty or `leastKey`
  /// exceeds `limit`.
  bool pop(double limit, int& item) {
    while (count_ > 0 && leastKey() <= limit) {
      Array<int>& bucket = buckets_[current_ & (kBuckets - 1)];
      if (next_ < bucket.count()) {
        item = bucket[next_++];
        --count_;
        return true;
      }
      bucket.clear();
      next_ = 0;
      ++current_;
    }
    return false;
  }

  void clear() {
    for (Array<int>& bucket : buckets_) bucket.clear();
    current_ = 0;
    next_ = 0;
    count_ = 0;
  }

 private:
  static constexpr int kBuckets = 512;

  double width_;
  double inverseWidth_;
  Array<Array<int>> buckets_;
  int current_ = 0;
  int next_ = 0;  ///< the index of the next item in the current bucket
  int64_t count_ = 0;
};

}  // namespace karcher

#pragma once

#include <algorithm>

#include "mesh/types.h"

namespace karcher {

/// A queue of items with keys >= 0. Items come out in the order of their keys, up to the width of a
/// bucket; within a bucket the first in is the first out. An item may be pushed into the bucket
/// that is being emptied. An item whose key is too far ahead for the ring of buckets comes out
/// early, never late.
class BucketQueue {
 public:
  explicit BucketQueue(double width)
      : width_(width), inverseWidth_(1 / width), buckets_(static_cast<size_t>(kBuckets)) {}

  /// The bucket a key belongs in, not before the one that is being emptied.
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

  /// The bucket that is being emptied, and the least key that may still come.
  int current() const { return current_; }
  double leastKey() const { return current_ * width_; }

  /// Takes the next item, unless the queue is empty or the least key is beyond `limit`.
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
  int next_ = 0;  ///< place in the current bucket
  int64_t count_ = 0;
};

}  // namespace karcher

#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "mesh/types.h"

namespace karcher {

/// A priority queue of items with keys >= 0 that rise slowly. Items come out in the order of their
/// keys, as floats, and of their numbers where keys are equal. An item whose key is below those
/// that came out already comes next. The key of a waiting item may be lowered.
///
/// Items wait in a ring of buckets of equal width; items beyond the ring wait in a bucket of their
/// own. Each bucket is a linked list: nothing is sorted, and no outdated entry is left behind. One
/// bit for each bucket says whether it holds something.
class OrderedQueue {
 public:
  explicit OrderedQueue(double width) : inverseWidth_(1 / width) {
    links_.reserve(static_cast<size_t>(kFirstPlace) + kRoom);
    links_.resize(static_cast<size_t>(kFirstPlace));
    entries_.reserve(kRoom);
  }

  bool empty() const { return count_ == 0; }

  /// Returns the item's place, for `lower`.
  int push(double key, int item) {
    int place = free_;
    if (place == kNone) {
      place = links_.count();
      links_.push_back({});
      entries_.push_back({});
    } else {
      free_ = links_[place].next;
    }
    entry(place).item = item;
    link(place, key);
    ++count_;
    return place;
  }

  /// Lowers the key of the item that waits at a place.
  void lower(int place, double key) {
    unlink(place);
    link(place, key);
  }

  /// Takes out the item that comes next. The queue must not be empty.
  int pop() {
    const int head = nextBucket();
    int best = links_[head].next;
    for (int place = links_[best].next; place != kNone; place = links_[place].next) {
      if (entry(place) < entry(best)) best = place;
    }
    unlink(best);
    links_[best].next = free_;
    free_ = best;
    --count_;
    return entry(best).item;
  }

  /// Forgets all items and their places.
  void clear() {
    links_.assign(static_cast<size_t>(kFirstPlace), {});
    entries_.clear();
    std::fill(isFilled_, isFilled_ + kWords, 0);
    free_ = kNone;
    count_ = 0;
    current_ = 0;
    leastFar_ = kNever;
  }

 private:
  static constexpr int kBuckets = 1024;
  static constexpr int64_t kMask = kBuckets - 1;
  static constexpr int kWords = kBuckets / 64;
  /// Numbers of nodes: none, the heads of the ring's buckets, that of the far one, then the items.
  static constexpr int kNone = 0;
  static constexpr int kFirstHead = 1;
  static constexpr int kFar = kFirstHead + kBuckets;
  static constexpr int kFirstPlace = kFar + 1;
  /// For so many items there is room from the start.
  static constexpr size_t kRoom = 256;
  static constexpr int64_t kNever = std::numeric_limits<int64_t>::max();

  struct Link {
    int next = kNone;
    int back = kNone;
  };
  struct Entry {
    float key = 0;
    int item = 0;
    bool operator<(const Entry& other) const {
      return key < other.key || (key == other.key && item < other.item);
    }
  };

  Entry& entry(int place) { return entries_.data()[place - kFirstPlace]; }

  int64_t bucketOf(double key) const { return static_cast<int64_t>(key * inverseWidth_); }

  void link(int place, double key) {
    const int64_t bucket = std::max(bucketOf(key), current_);
    int head = kFar;
    if (bucket < current_ + kBuckets) {
      const int64_t slot = bucket & kMask;
      isFilled_[slot >> 6] |= uint64_t{1} << (slot & 63);
      head = kFirstHead + static_cast<int>(slot);
    } else {
      leastFar_ = std::min(leastFar_, bucket);
    }
    entry(place).key = static_cast<float>(key);
    const int next = links_[head].next;
    links_[place] = {next, head};
    links_[next].back = place;
    links_[head].next = place;
  }

  void unlink(int place) {
    const Link& node = links_[place];
    links_[node.back].next = node.next;
    links_[node.next].back = node.back;
    if (node.next == kNone && node.back < kFar) {
      const int slot = node.back - kFirstHead;
      isFilled_[slot >> 6] &= ~(uint64_t{1} << (slot & 63));
    }
  }

  /// Goes on to the first bucket that holds something, and returns its head.
  int nextBucket() {
    for (;;) {
      const int64_t bucket = firstFilled();
      if (bucket < leastFar_) {
        current_ = bucket;
        return kFirstHead + static_cast<int>(bucket & kMask);
      }
      if (bucket == kNever) current_ = leastFar_;
      takeFromFar();
    }
  }

  /// The first bucket of the ring that holds something, kNever if none does.
  int64_t firstFilled() const {
    const int first = static_cast<int>(current_ & kMask);
    uint64_t word = isFilled_[first >> 6] >> (first & 63);
    if (word != 0) return current_ + std::countr_zero(word);
    int64_t start = current_ - (first & 63);
    for (int i = 1; i <= kWords; ++i) {
      start += 64;
      word = isFilled_[(start & kMask) >> 6];
      if (word != 0) return start + std::countr_zero(word);
    }
    return kNever;
  }

  /// Moves the far items that the ring now reaches into it.
  void takeFromFar() {
    int place = links_[kFar].next;
    links_[kFar].next = kNone;
    leastFar_ = kNever;
    while (place != kNone) {
      const int next = links_[place].next;
      link(place, static_cast<double>(entry(place).key));
      place = next;
    }
  }

  double inverseWidth_;
  Array<Link> links_;
  Array<Entry> entries_;  ///< by place, from kFirstPlace on
  uint64_t isFilled_[kWords] = {};
  int free_ = kNone;  ///< the first of the places that are not taken, linked by `next`
  int64_t count_ = 0;
  int64_t current_ = 0;        ///< nothing waits in the buckets before
  int64_t leastFar_ = kNever;  ///< no far item belongs in a bucket before
};

}  // namespace karcher

#pragma once

#include <limits>
#include <memory>
#include <utility>

#include "distance/paged_array.h"
#include "distance/window.h"

namespace karcher {

/// The windows that wait at half-edges to be propagated across their faces. They lie along the
/// wavefront, so memory that the wavefront has left behind is used again ahead of it.
class WaitingWindows {
 public:
  WaitingWindows(int faceCount, std::shared_ptr<PagePool> pages)
      : pages_((faceCount >> kPageBits) + 1, std::move(pages)) {}

  /// Adds a window that leaves the queue with `bucket`. Returns whether it leaves before all others
  /// at its half-edge.
  bool add(int h, const Window& window, int bucket) {
    Page& page = pages_.touch(faceOf(h) >> kPageBits);
    int& first = page.firstAt(h);
    int before = std::numeric_limits<int>::max();
    if (first < 0) {
      ++page.used;
    } else {
      before = blocks_[first].bucket;
    }
    if (first < 0 || blocks_[first].count == Block::kCapacity) {
      const int block = takeBlock();
      blocks_[block].next = std::exchange(first, block);
    }
    Block& block = blocks_[first];
    block.bucket = std::min(bucket, before);
    block.windows[block.count++] = window;
    return bucket < before;
  }

  /// Whether windows wait at half-edge h and the first of them leaves with this bucket.
  bool isDue(int h, int bucket) const {
    const Page* page = pages_.find(faceOf(h) >> kPageBits);
    if (page == nullptr) return false;
    const int first = page->firstAt(h);
    return first >= 0 && blocks_[first].bucket == bucket;
  }

  /// Moves the windows of a half-edge to a batch. Requires at least one window.
  void take(int h, Array<Window>& batch) {
    const int number = faceOf(h) >> kPageBits;
    Page& page = pages_.touch(number);
    batch.clear();
    for (int i = std::exchange(page.firstAt(h), -1); i >= 0;) {
      Block& block = blocks_[i];
      batch.insert(batch.end(), block.windows, block.windows + block.count);
      const int after = std::exchange(block.next, free_);
      free_ = i;
      i = after;
    }
    if (--page.used == 0) pages_.drop(number);
  }

  int64_t bytesHeld() const {
    return pages_.bytesHeld() + static_cast<int64_t>(blocks_.capacity() * sizeof(Block));
  }

  void clear() {
    pages_.clear();
    blocks_.clear();
    free_ = -1;
  }

 private:
  static constexpr int kPageBits = 7;

  /// Up to kCapacity windows of a half-edge, and the index of the block with more of its windows.
  struct Block {
    static constexpr int kCapacity = 8;
    int count = 0;
    int next = -1;
    int bucket = 0;  ///< in the first block: the least bucket of the half-edge's windows
    Window windows[kCapacity];
  };
  /// For each half-edge of 2^kPageBits faces, the index of its first block, or -1.
  struct Page {
    static constexpr int kSize = 3 << kPageBits;
    Page() { std::fill_n(first, kSize, -1); }
    int& firstAt(int h) { return first[h % kSize]; }
    int firstAt(int h) const { return first[h % kSize]; }
    int used = 0;  ///< the number of half-edges at which windows wait
    int first[kSize];
  };

  int takeBlock() {
    if (free_ < 0) {
      blocks_.emplace_back();
      return blocks_.count() - 1;
    }
    const int block = std::exchange(free_, blocks_[free_].next);
    blocks_[block].count = 0;
    return block;
  }

  PagedArray<Page, 0> pages_;
  Array<Block> blocks_;
  int free_ = -1;
};

}  // namespace karcher

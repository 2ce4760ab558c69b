#pragma once

#include <cstddef>
#include <memory>

#include "mesh/types.h"

namespace karcher {

/// Memory for the pages of paged arrays. A page that one array returns is used again by the next.
/// So fields that move over a surface take new memory only when their total need exceeds every
/// earlier one.
class PagePool {
 public:
  PagePool() = default;
  ~PagePool() { trim(); }
  PagePool(const PagePool&) = delete;
  PagePool& operator=(const PagePool&) = delete;

  /// Takes a page of `bytes` for an array, and appends the page's number to the array's `numbers`.
  void* take(size_t bytes, int number, Array<int>& numbers);
  void give(void* page, size_t bytes) noexcept;

  /// Frees the blocks in which no array holds a page.
  void trim() noexcept;

 private:
  /// The content of a page that no array holds.
  struct Spare {
    Spare* next;
  };
  /// Pages side by side in one allocation.
  struct Block {
    std::byte* memory;
    int pages;
    int spare;  ///< the number of the block's spare pages, which `trim` counts
  };
  /// The pages of one size.
  struct Shelf {
    size_t bytes = 0;
    int pages = 0;        ///< the number of pages, spare or in use
    Array<Block> blocks;  ///< the blocks in the order of their addresses
    Spare* spare = nullptr;
  };

  Shelf& shelfOf(size_t bytes);
  static void grow(Shelf& shelf);
  static void trim(Shelf& shelf) noexcept;
  static void put(Shelf& shelf, void* page) noexcept;

  /// The largest number of page sizes in one pool.
  static constexpr int kSizes = 8;

  Shelf shelves_[kSizes];
};

std::shared_ptr<PagePool> newPagePool();

}  // namespace karcher

#pragma once

#include <cstddef>

#include "mesh/types.h"

namespace karcher {

/// Memory for the pages of paged arrays. What one array gives back the next one takes, so that
/// fields that move over a surface take new memory only where all of them together need more than
/// they ever did.
class PagePool {
 public:
  PagePool() = default;
  ~PagePool() { trim(); }
  PagePool(const PagePool&) = delete;
  PagePool& operator=(const PagePool&) = delete;

  /// A page of so many bytes.
  void* take(size_t bytes);
  void give(void* page, size_t bytes) noexcept;

  /// Gives the memory of pages that nobody has back.
  void trim() noexcept;

 private:
  /// What stands in a page that nobody has.
  struct Spare {
    Spare* next;
  };
  /// The pages of one size.
  struct Shelf {
    size_t bytes = 0;
    int pages = 0;  ///< spare ones and others
    Spare* spare = nullptr;
  };

  Shelf& shelfOf(size_t bytes);
  static void put(Shelf& shelf, void* page) noexcept;

  Array<Shelf> shelves_;
};

}  // namespace karcher

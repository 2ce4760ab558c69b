#include "distance/page_pool.h"

#include <new>

namespace karcher {
namespace {

/// Where there is no spare page, this part of all pages is made at once.
constexpr int kGrowth = 8;

}  // namespace

PagePool::Shelf& PagePool::shelfOf(size_t bytes) {
  for (Shelf& shelf : shelves_) {
    if (shelf.bytes == bytes) return shelf;
  }
  return shelves_.emplace_back(Shelf{bytes});
}

void PagePool::put(Shelf& shelf, void* page) noexcept {
  shelf.spare = new (page) Spare{shelf.spare};
}

void* PagePool::take(size_t bytes) {
  Shelf& shelf = shelfOf(bytes);
  if (shelf.spare == nullptr) {
    for (int more = 1 + shelf.pages / kGrowth; more > 0; --more) {
      put(shelf, ::operator new(bytes));
      ++shelf.pages;
    }
  }
  Spare* const page = shelf.spare;
  shelf.spare = page->next;
  return page;
}

void PagePool::give(void* page, size_t bytes) noexcept { put(shelfOf(bytes), page); }

void PagePool::trim() noexcept {
  for (Shelf& shelf : shelves_) {
    while (shelf.spare != nullptr) {
      Spare* const page = shelf.spare;
      shelf.spare = page->next;
      ::operator delete(page);
      --shelf.pages;
    }
  }
}

}  // namespace karcher

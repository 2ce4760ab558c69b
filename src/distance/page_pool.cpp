#include "distance/page_pool.h"

#include <new>

namespace karcher {
namespace {

/// Where there is no spare page, this part of all pages is made at once.
constexpr int kGrowth = 8;

/// For so many numbers there is room from the start.
constexpr size_t kFirstNumbers = 64;

}  // namespace

PagePool::Shelf& PagePool::shelfOf(size_t bytes) {
  int i = 0;
  while (i + 1 < kSizes && shelves_[i].bytes != 0 && shelves_[i].bytes != bytes) ++i;
  if (shelves_[i].bytes == 0) shelves_[i].bytes = bytes;
  if (shelves_[i].bytes != bytes) throw std::bad_alloc();
  return shelves_[i];
}

void PagePool::put(Shelf& shelf, void* page) noexcept {
  shelf.spare = new (page) Spare{shelf.spare};
}

void* PagePool::take(size_t bytes, int number, Array<int>& numbers) {
  // First, so that a page that was taken is known to be.
  if (numbers.size() == numbers.capacity()) numbers.reserve(2 * numbers.size() + kFirstNumbers);
  Shelf& shelf = shelfOf(bytes);
  if (shelf.spare == nullptr) {
    for (int more = 1 + shelf.pages / kGrowth; more > 0; --more) {
      put(shelf, ::operator new(bytes));
      ++shelf.pages;
    }
  }
  Spare* const page = shelf.spare;
  shelf.spare = page->next;
  numbers.push_back(number);
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

std::shared_ptr<PagePool> newPagePool() { return std::make_shared<PagePool>(); }

}  // namespace karcher

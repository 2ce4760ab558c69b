#include "distance/page_pool.h"

#include <algorithm>
#include <functional>
#include <new>
#include <utility>

namespace karcher {
namespace {

/// If no page of a size is spare, the pool allocates a block. The block has 1 / kGrowth of the
/// present number of pages of this size, plus one.
constexpr int kGrowth = 8;

/// The number of page numbers for which an array first reserves memory.
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
  // The array grows first, so that it can always record the page's number.
  if (numbers.size() == numbers.capacity()) numbers.reserve(2 * numbers.size() + kFirstNumbers);
  Shelf& shelf = shelfOf(bytes);
  if (shelf.spare == nullptr) grow(shelf);
  Spare* const page = shelf.spare;
  shelf.spare = page->next;
  numbers.push_back(number);
  return page;
}

void PagePool::give(void* page, size_t bytes) noexcept { put(shelfOf(bytes), page); }

void PagePool::grow(Shelf& shelf) {
  const int more = 1 + shelf.pages / kGrowth;
  // The list grows first, so that it can always record the block.
  if (shelf.blocks.size() == shelf.blocks.capacity())
    shelf.blocks.reserve(2 * shelf.blocks.size() + 8);
  auto* const memory =
      static_cast<std::byte*>(::operator new(static_cast<size_t>(more) * shelf.bytes));
  const auto place = std::upper_bound(
      shelf.blocks.begin(), shelf.blocks.end(), memory,
      [](const std::byte* m, const Block& block) { return std::less<>()(m, block.memory); });
  shelf.blocks.insert(place, {memory, more, 0});
  for (int i = more - 1; i >= 0; --i) put(shelf, memory + static_cast<size_t>(i) * shelf.bytes);
  shelf.pages += more;
}

void PagePool::trim() noexcept {
  for (Shelf& shelf : shelves_) trim(shelf);
}

void PagePool::trim(Shelf& shelf) noexcept {
  const auto blockOf = [&](const Spare* page) -> Block& {
    const auto behind = std::upper_bound(shelf.blocks.begin(), shelf.blocks.end(), page,
                                         [](const Spare* p, const Block& block) {
                                           return std::less<const void*>()(p, block.memory);
                                         });
    return *(behind - 1);
  };
  for (Block& block : shelf.blocks) block.spare = 0;
  for (const Spare* page = shelf.spare; page; page = page->next) ++blockOf(page).spare;
  Spare* page = std::exchange(shelf.spare, nullptr);
  while (page != nullptr) {
    Spare* const next = page->next;
    const Block& block = blockOf(page);
    if (block.spare < block.pages) put(shelf, page);
    page = next;
  }
  std::erase_if(shelf.blocks, [&](const Block& block) {
    if (block.spare < block.pages) return false;
    shelf.pages -= block.pages;
    ::operator delete(block.memory);
    return true;
  });
}

std::shared_ptr<PagePool> newPagePool() { return std::make_shared<PagePool>(); }

}  // namespace karcher

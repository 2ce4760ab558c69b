#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "distance/page_pool.h"

namespace karcher {

/// An array indexed by vertex or face that has memory only for touched pages. A search within a
/// neighbourhood allocates and clears memory for the neighbourhood, not for the mesh. References
/// stay valid until `clear`.
template <class T, int kPageBits>
class PagedArray {
 public:
  /// Pages come from the pool, which other arrays may share.
  explicit PagedArray(int count, std::shared_ptr<PagePool> pool = newPagePool())
      : count_(count),
        pageOf_(static_cast<size_t>(count >> kPageBits) + 1, nullptr),
        pool_(std::move(pool)) {}
  PagedArray(PagedArray&&) noexcept = default;
  PagedArray& operator=(PagedArray&&) = delete;
  ~PagedArray() { clear(); }

  /// The element. Creates it if it does not exist.
  T& touch(int i) {
    T* page = pageOf_[i >> kPageBits];
    if (page == nullptr) page = addPage(i >> kPageBits);
    return page[i & kMask];
  }

  /// The element, or null if its page does not exist.
  const T* find(int i) const {
    const T* page = pageOf_[i >> kPageBits];
    return page == nullptr ? nullptr : page + (i & kMask);
  }

  /// Calls visit(i) for the number of every existing element, including untouched ones of touched
  /// pages. Requires that no page was dropped since `clear`.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const int page : used_) {
      const int end = std::min((page + 1) << kPageBits, count_);
      for (int i = page << kPageBits; i < end; ++i) visit(i);
    }
  }

  /// The bytes of all pages.
  int64_t bytesHeld() const { return static_cast<int64_t>(held_ * kBytes); }

  /// Removes every element, in time linear in the number of touched pages. The pool keeps the
  /// memory.
  [[gnu::noinline]] void clear() {
    for (const int page : used_) drop(page << kPageBits);
    used_.clear();
  }

  /// Removes the page of element i, if it exists.
  void drop(int i) {
    void* const page = std::exchange(pageOf_[i >> kPageBits], nullptr);
    if (page == nullptr) return;
    pool_->give(page, kBytes);
    --held_;
  }

 private:
  static constexpr int kMask = (1 << kPageBits) - 1;
  /// The size of a page. It is a multiple of the alignment of a pointer, since the pool stores a
  /// pointer in each page that no array holds.
  static constexpr size_t kBytes =
      ((sizeof(T) << kPageBits) + alignof(void*) - 1) / alignof(void*) * alignof(void*);
  static_assert(std::is_trivially_destructible_v<T>);
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  [[gnu::noinline]] T* addPage(int index) {
    T* const page = static_cast<T*>(pool_->take(kBytes, index, used_));
    std::uninitialized_fill(page, page + kMask + 1, T{});
    ++held_;
    return pageOf_[index] = page;
  }

  int count_;
  Array<T*> pageOf_;
  /// the numbers of the created pages, in the order of their creation; the number of a dropped page
  /// stays, and is added again if the page is created again
  Array<int> used_;
  size_t held_ = 0;
  std::shared_ptr<PagePool> pool_;
};

}  // namespace karcher

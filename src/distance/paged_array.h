#pragma once

#include <algorithm>
#include <memory>

#include "mesh/types.h"

namespace karcher {

/// An array indexed by vertex or face, of which only the touched pages exist. A search that stays
/// in a neighbourhood takes and clears memory for the neighbourhood, not for the mesh. References
/// stay valid until `clear`.
template <class T, int kPageBits>
class PagedArray {
 public:
  explicit PagedArray(int count)
      : count_(count), pageOf_(static_cast<size_t>(count >> kPageBits) + 1, nullptr) {}

  /// The element, made if it does not exist yet.
  T& touch(int i) {
    T* page = pageOf_[i >> kPageBits];
    if (page == nullptr) page = addPage(i >> kPageBits);
    return page[i & kMask];
  }

  /// The element, or null where nothing near it was touched.
  const T* find(int i) const {
    const T* page = pageOf_[i >> kPageBits];
    return page == nullptr ? nullptr : page + (i & kMask);
  }

  /// Calls visit(i) for the number of every element that exists; some of a page may never have been
  /// touched.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (const int page : used_) {
      const int end = std::min((page + 1) << kPageBits, count_);
      for (int i = page << kPageBits; i < end; ++i) visit(i);
    }
  }

  /// Forgets every element. Costs what was touched; the memory is kept.
  void clear() {
    for (const int page : used_) pageOf_[page] = nullptr;
    used_.clear();
  }

 private:
  static constexpr int kMask = (1 << kPageBits) - 1;

  T* addPage(int index) {
    if (used_.size() == pages_.size()) pages_.push_back(std::make_unique<T[]>(kMask + 1));
    T* page = pages_[used_.size()].get();
    std::fill(page, page + kMask + 1, T{});
    pageOf_[index] = page;
    used_.push_back(index);
    return page;
  }

  int count_;
  Array<T*> pageOf_;
  Array<int> used_;
  Array<std::unique_ptr<T[]>> pages_;
};

}  // namespace karcher

#pragma once

#include <bit>
#include <cstdint>

#include "mesh/types.h"

namespace karcher {

/// An index that gives the numbers 0, 1, 2, ... to the few items (faces, cells) that a search
/// meets, in the order in which the search adds them. The index uses open addressing, so that its
/// memory does not grow with the mesh.
class SparseIndex {
 public:
  int count() const { return static_cast<int>(places_.size()); }

  /// The number of an item >= 0, or -1.
  int find(int item) const {
    uint32_t place = placeOf(item);
    while (entries_.data()[place].item != item) {
      if (entries_.data()[place].item < 0) return -1;
      place = (place + 1) & mask_;
    }
    return entries_.data()[place].number;
  }

  /// Gives the next number to an item that has none.
  void add(int item) {
    if (2 * places_.size() >= entries_.size()) grow();
    insert(item, count());
  }

  /// Removes all items, in time linear in their number. Keeps the memory.
  void clear() {
    for (const uint32_t place : places_) entries_.data()[place].item = -1;
    places_.clear();
  }

 private:
  struct Entry {
    int item = -1;
    int number = 0;
  };

  /// The high bits of the product depend on all bits of the item (D. Knuth, "The Art of Computer
  /// Programming", vol. 3, section 6.4: Fibonacci hashing).
  uint32_t placeOf(int item) const { return (static_cast<uint32_t>(item) * 2654435769u) >> shift_; }

  void insert(int item, int number) {
    uint32_t place = placeOf(item);
    while (entries_.data()[place].item >= 0) place = (place + 1) & mask_;
    places_.push_back(place);
    entries_.data()[place] = {item, number};
  }

  void grow() {
    Array<Entry> before(2 * entries_.size());
    before.swap(entries_);
    mask_ = static_cast<uint32_t>(entries_.size()) - 1;
    --shift_;
    places_.clear();
    for (const Entry& entry : before) {
      if (entry.item >= 0) insert(entry.item, entry.number);
    }
  }

  static constexpr int kFirstBits = 8;

  /// the entries; their number is a power of two
  Array<Entry> entries_ = Array<Entry>(size_t{1} << kFirstBits);
  uint32_t mask_ = (uint32_t{1} << kFirstBits) - 1;
  int shift_ = 32 - kFirstBits;
  Array<uint32_t> places_;  ///< the places of the occupied entries
};

}  // namespace karcher

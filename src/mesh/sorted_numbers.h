#pragma once

#include <functional>

#include "mesh/types.h"

/// A sort for callers that need it rarely. Each instance of std::sort would add three kilobytes of
/// code.
namespace karcher {

/// Sorts numbers by a comparison. Numbers that compare as equal are in ascending order.
void sortNumbers(Array<int>& numbers, const std::function<bool(int, int)>& isBefore);

/// The numbers from 0 to count - 1, sorted in the same way.
Array<int> sortedNumbers(int count, const std::function<bool(int, int)>& isBefore);

/// Sorts items by a comparison. Items that compare as equal keep their order.
template <class Item, class Comparison>
void sortItems(Array<Item>& items, const Comparison& isBefore) {
  Array<Item> sorted;
  sorted.reserve(items.size());
  for (const int i :
       sortedNumbers(items.count(), [&](int a, int b) { return isBefore(items[a], items[b]); })) {
    sorted.push_back(items[i]);
  }
  items.swap(sorted);
}

}  // namespace karcher

#include "mesh/sorted_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "generators/random.h"

namespace karcher {
namespace {

TEST(SortedNumbers, AreThoseOfAStableSort) {
  Random random(9);
  for (const int count : {0, 1, 2, 50, 3000}) {
    SCOPED_TRACE("seed 9, " + std::to_string(count) + " numbers");
    Array<int> keys;
    for (int i = 0; i < count; ++i) keys.push_back(random.index(20));
    const auto isBefore = [&](int a, int b) { return keys[a] < keys[b]; };
    Array<int> expected(static_cast<size_t>(count));
    std::iota(expected.begin(), expected.end(), 0);
    std::stable_sort(expected.begin(), expected.end(), isBefore);
    EXPECT_EQ(sortedNumbers(count, isBefore), expected);
    Array<int> shuffled = expected;
    random.shuffle(shuffled);
    sortNumbers(shuffled, isBefore);
    EXPECT_EQ(shuffled, expected);
  }
}

TEST(SortedNumbers, EqualItemsKeepTheirOrder) {
  Random random(10);
  for (const int count : {0, 1, 2, 50, 3000}) {
    SCOPED_TRACE("seed 10, " + std::to_string(count) + " items");
    Array<std::pair<int, int>> items;
    for (int i = 0; i < count; ++i) items.push_back({random.index(20), i});
    Array<std::pair<int, int>> expected = items;
    std::sort(expected.begin(), expected.end());
    sortItems(items, [](const auto& a, const auto& b) { return a.first < b.first; });
    EXPECT_EQ(items, expected);
  }
}

}  // namespace
}  // namespace karcher

#pragma once

#include <functional>

#include "mesh/types.h"

/// One sort for whatever is sorted seldom. A sort compiled for each caller would take three
/// kilobytes of code each.
namespace karcher {

/// Sorts numbers by a comparison. Numbers that it holds equal are put in ascending order.
void sortNumbers(Array<int>& numbers, const std::function<bool(int, int)>& isBefore);

/// The numbers from 0 to count - 1, sorted in the same way.
Array<int> sortedNumbers(int count, const std::function<bool(int, int)>& isBefore);

}  // namespace karcher

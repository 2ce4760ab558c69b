#pragma once

#include <functional>

#include "mesh/types.h"

/// A sort shared by rare callers: each instance of std::sort would add three kilobytes of code.
namespace karcher {

/// Sorts numbers by a comparison, and equal ones in ascending order.
void sortNumbers(Array<int>& numbers, const std::function<bool(int, int)>& isBefore);

/// The numbers from 0 to count - 1, sorted in the same way.
Array<int> sortedNumbers(int count, const std::function<bool(int, int)>& isBefore);

}  // namespace karcher

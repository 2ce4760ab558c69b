#pragma once

#include <functional>

#include "mesh/types.h"

/// One sort for all that is not sorted often: each caller's own takes three kilobytes of a page's
/// module.
namespace karcher {

/// Sorts numbers by a comparison, those of which neither is before the other from the lowest up.
void sortNumbers(Array<int>& numbers, const std::function<bool(int, int)>& isBefore);

/// 0, ..., count - 1, sorted so.
Array<int> sortedNumbers(int count, const std::function<bool(int, int)>& isBefore);

}  // namespace karcher

#include "mesh/sorted_numbers.h"

#include <algorithm>
#include <numeric>

namespace karcher {

void sortNumbers(Array<int>& numbers, const std::function<bool(int, int)>& isBefore) {
  std::sort(numbers.begin(), numbers.end(), [&](int a, int b) {
    if (isBefore(a, b)) return true;
    return a < b && !isBefore(b, a);
  });
}

Array<int> sortedNumbers(int count, const std::function<bool(int, int)>& isBefore) {
  Array<int> numbers(static_cast<size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  sortNumbers(numbers, isBefore);
  return numbers;
}

}  // namespace karcher

#pragma once

#include <span>

#include "support.h"

namespace karcher {

/// The number of cases: all, or `watched` if the sanitizers omit the longest tests.
inline int casesOf(int all, int watched) { return leavesLongestOut() ? watched : all; }

/// The cases of a list: all, or the first `watched` if the sanitizers omit the longest tests.
template <typename Case, int kCount>
std::span<const Case> casesOf(const Case (&all)[kCount], int watched) {
  return {all, all + casesOf(kCount, watched)};
}

}  // namespace karcher

#pragma once

#include <span>

#include "support.h"

namespace karcher {

/// Of so many like cases all, or where the sanitizers leave the longest out as many as `watched`.
inline int casesOf(int all, int watched) { return leavesLongestOut() ? watched : all; }

/// The same of cases that are told: the first ones.
template <typename Case, int kCount>
std::span<const Case> casesOf(const Case (&all)[kCount], int watched) {
  return {all, all + casesOf(kCount, watched)};
}

}  // namespace karcher

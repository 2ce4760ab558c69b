#pragma once

#include <cstdint>

namespace karcher {

/// How often the program has taken memory by `new` so far; with the address sanitizer by `malloc`,
/// too. A program that asks has its operator new replaced.
int64_t allocationsSoFar();

}  // namespace karcher

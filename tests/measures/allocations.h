#pragma once

#include <cstdint>

/// Counts the memory that the program takes by `new`; with the address sanitizer also by `malloc`.
/// A program that uses these functions has its operator new replaced.
namespace karcher {

/// The number of allocations of the program so far.
int64_t allocationsSoFar();

/// The number of bytes it has taken so far, including freed ones.
int64_t bytesTakenSoFar();

/// The number of bytes it holds now.
int64_t bytesHeld();

}  // namespace karcher

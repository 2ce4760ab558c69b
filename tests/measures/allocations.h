#pragma once

#include <cstdint>

/// Counts of the memory that the program takes by `new`; with the address sanitizer also by
/// `malloc`. These functions replace the operator new of a program.
namespace karcher {

/// The number of allocations of the program so far.
int64_t allocationsSoFar();

/// The number of bytes that the program has taken so far, including freed ones.
int64_t bytesTakenSoFar();

/// The number of bytes that the program holds now.
int64_t bytesHeld();

/// Lets one allocation fail, after `count` others; a negative count lets none fail. Without effect
/// with the address sanitizer.
void failAllocationAfter(int64_t count);

}  // namespace karcher

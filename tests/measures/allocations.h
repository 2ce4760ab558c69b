#pragma once

#include <cstdint>

/// What the program takes by `new`; with the address sanitizer by `malloc`, too. A program that
/// asks has its operator new replaced.
namespace karcher {

/// How often the program has taken memory so far.
int64_t allocationsSoFar();

/// How many bytes it has taken so far, also those that it has given back.
int64_t bytesTakenSoFar();

/// How many bytes it holds now.
int64_t bytesHeld();

}  // namespace karcher

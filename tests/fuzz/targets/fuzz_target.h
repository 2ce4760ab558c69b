#pragma once

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "fuzz/fuzz_checks.h"

namespace karcher {

/// Runs a check for libFuzzer, which keeps the input for which the program aborts.
inline int fuzzed(void (*check)(Bytes), const uint8_t* data, size_t size) {
  try {
    check({data, size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "finding: %s\n", error.what());
    std::abort();
  }
  return 0;
}

}  // namespace karcher

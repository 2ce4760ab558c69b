#pragma once

#include "fuzz/fuzz_bytes.h"

/// The seeds of fuzzers: small cases that reach most of the code under test.
namespace karcher {

using Seed = Array<uint8_t>;

Array<Seed> objSeeds();
Array<Seed> repairsSeeds();
Array<Seed> curveSeeds();

}  // namespace karcher

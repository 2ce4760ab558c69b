#pragma once

#include "fuzz/fuzz_bytes.h"

/// What fuzzers start from: small cases that reach most of what they are to change.
namespace karcher {

using Seed = Array<uint8_t>;

Array<Seed> objSeeds();
Array<Seed> repairsSeeds();
Array<Seed> curveSeeds();

}  // namespace karcher

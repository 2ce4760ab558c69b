#pragma once

#include <cstdint>
#include <random>
#include <utility>

#include "mesh/types.h"

namespace karcher {

/// Random numbers that are the same on every platform: the standard fixes the engine's output but
/// not that of its distributions.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  /// A uniform number in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// A uniform number from 0 to count - 1.
  int index(int count) { return static_cast<int>(uniform() * count); }
  /// Permutes the values uniformly.
  void shuffle(Array<int>& values) {
    for (int i = values.count() - 1; i > 0; --i) std::swap(values[i], values[index(i + 1)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace karcher

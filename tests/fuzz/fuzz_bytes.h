#pragma once

#include <cstdint>
#include <span>

#include "mesh/types.h"

/// The bytes of a fuzzer, read as numbers; after the end all are 0. A byte always has the same
/// meaning in the same place, so that a small change of the bytes is a small change of the case.
namespace karcher {

using Bytes = std::span<const uint8_t>;

class FuzzBytes {
 public:
  explicit FuzzBytes(Bytes bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return next_ >= bytes_.size(); }
  int byte() { return isAtEnd() ? 0 : bytes_[next_++]; }
  /// A number from 0 to count - 1; `count` is at most 65,536.
  int index(int count) {
    const int low = byte();
    return (count > 256 ? low + 256 * byte() : low) % count;
  }
  bool flag() { return byte() % 2 == 1; }
  /// A number in [0, 1], both ends included.
  double unit() {
    const int low = byte();
    return (low + 256 * byte()) / 65'535.0;
  }

 private:
  Bytes bytes_;
  size_t next_ = 0;
};

}  // namespace karcher

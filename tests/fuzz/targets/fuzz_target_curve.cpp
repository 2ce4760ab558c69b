#include "fuzz/targets/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return karcher::fuzzed(karcher::fuzzCurve, data, size);
}

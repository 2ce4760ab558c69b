#include "measures/allocations.h"

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

#if defined(__SANITIZE_ADDRESS__)
#define KARCHER_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define KARCHER_ADDRESS_SANITIZER
#endif
#endif

namespace {

int64_t allocations = 0;
int64_t bytesTaken = 0;
int64_t bytesGivenBack = 0;
int64_t beforeFailure = -1;

void countTaken(size_t bytes) {
  ++allocations;
  bytesTaken += static_cast<int64_t>(bytes);
}

void countGivenBack(size_t bytes) { bytesGivenBack += static_cast<int64_t>(bytes); }

}  // namespace

int64_t karcher::allocationsSoFar() { return allocations; }
int64_t karcher::bytesTakenSoFar() { return bytesTaken; }
int64_t karcher::bytesHeld() { return bytesTaken - bytesGivenBack; }
void karcher::failAllocationAfter(int64_t count) { beforeFailure = count; }

#ifdef KARCHER_ADDRESS_SANITIZER

// The sanitizer keeps its own operator new, which reports more.
#include <sanitizer/allocator_interface.h>

namespace {

const int kInstalled = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, size_t bytes) { countTaken(bytes); },
    [](const volatile void* memory) {
      if (memory != nullptr) countGivenBack(__sanitizer_get_allocated_size(memory));
    });

}  // namespace

#else

namespace {

/// The size of each piece of memory stands before it, at a distance that keeps the alignment.
constexpr size_t kHeader = alignof(std::max_align_t);
static_assert(kHeader >= sizeof(size_t));

void* take(size_t size) {
  if (beforeFailure >= 0 && --beforeFailure < 0) throw std::bad_alloc();
  countTaken(size);
  if (void* memory = std::malloc(kHeader + size)) {
    std::memcpy(memory, &size, sizeof size);
    return static_cast<char*>(memory) + kHeader;
  }
  throw std::bad_alloc();
}

void giveBack(void* memory) {
  if (memory == nullptr) return;
  void* const start = static_cast<char*>(memory) - kHeader;
  size_t size = 0;
  std::memcpy(&size, start, sizeof size);
  countGivenBack(size);
  std::free(start);
}

}  // namespace

void* operator new(size_t size) { return take(size); }
void* operator new[](size_t size) { return take(size); }
void operator delete(void* memory) noexcept { giveBack(memory); }
void operator delete[](void* memory) noexcept { giveBack(memory); }
void operator delete(void* memory, size_t) noexcept { giveBack(memory); }
void operator delete[](void* memory, size_t) noexcept { giveBack(memory); }

#endif

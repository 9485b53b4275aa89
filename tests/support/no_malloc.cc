#include "support/no_malloc.h"

#include <cstdlib>
#include <new>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define SOMATO_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SOMATO_SANITIZED
#endif

namespace {

thread_local std::size_t allocations = 0;

}  // namespace

namespace somato::testing {

bool counts_allocations() {
#if defined(SOMATO_SANITIZED)
  return false;
#else
  return true;
#endif
}

AllocationCounter::AllocationCounter() : before_(allocations) {}

std::size_t AllocationCounter::count() const {
  return allocations - before_;
}

}  // namespace somato::testing

#if !defined(SOMATO_SANITIZED)

// The forms not replaced here (arrays, nothrow, sized) call these.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto line = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(line, (size / line + 1) * line)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}

#endif

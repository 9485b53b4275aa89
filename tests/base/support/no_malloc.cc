#include "base/support/no_malloc.h"

#include <malloc.h>

#include <algorithm>
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
thread_local std::size_t held = 0;
thread_local std::size_t most_held = 0;

#if !defined(SOMATO_SANITIZED)

void* note(void* memory) {
  if (!memory) throw std::bad_alloc();
  ++allocations;
  held += malloc_usable_size(memory);
  most_held = std::max(most_held, held);
  return memory;
}

void release(void* memory) noexcept {
  held -= malloc_usable_size(memory);
  std::free(memory);
}

#endif

}  // namespace

namespace somato::testing {

bool counts_allocations() {
#if defined(SOMATO_SANITIZED)
  return false;
#else
  return true;
#endif
}

AllocationCounter::AllocationCounter() : before_(allocations), held_before_(held) {
  most_held = held;
}

std::size_t AllocationCounter::count() const {
  return allocations - before_;
}

std::size_t AllocationCounter::most_bytes() const {
  return most_held - held_before_;
}

}  // namespace somato::testing

#if !defined(SOMATO_SANITIZED)

// The forms not replaced here (arrays, nothrow, sized) call these.
void* operator new(std::size_t size) {
  return note(std::malloc(size != 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto line = static_cast<std::size_t>(alignment);
  return note(std::aligned_alloc(line, (size / line + 1) * line));
}

void operator delete(void* memory) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept {
  release(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}

#endif

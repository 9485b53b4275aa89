#include "somato/core/matrix.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace somato::detail {
namespace {

constexpr std::size_t kLine = 64;
constexpr std::size_t kLargePage = std::size_t{1} << 21U;
constexpr std::size_t kLarge = 2 * kLargePage;

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes < kLarge ? kLine : kLargePage};
}

}  // namespace

void* allocate_lines(std::size_t bytes) {
  void* memory = ::operator new(bytes, alignment_of(bytes));
#if defined(__linux__)
  // Advice: whether it is taken changes nothing but speed.
  if (bytes >= kLarge) madvise(memory, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_lines(void* memory, std::size_t bytes) noexcept {
  ::operator delete(memory, bytes, alignment_of(bytes));
}

}  // namespace somato::detail

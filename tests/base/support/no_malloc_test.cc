#include "base/support/no_malloc.h"

#include <gtest/gtest.h>

#include <new>
#include <thread>
#include <vector>

#include "somato/core/matrix.h"

namespace somato::testing {
namespace {

TEST(AllocationCounter, CountsEveryFormOfNew) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer brings its own operator new";
  const AllocationCounter counter;
  ::operator delete(::operator new(24));
  EXPECT_EQ(counter.count(), 1U);
  ::operator delete[](::operator new[](24));
  EXPECT_EQ(counter.count(), 2U);
  ::operator delete(::operator new(24, std::nothrow), std::nothrow);
  EXPECT_EQ(counter.count(), 3U);
  std::vector<int> plain(5);
  EXPECT_EQ(counter.count(), 4U) << plain.size();
  AlignedVector<float> aligned(5);
  EXPECT_EQ(counter.count(), 5U) << aligned.size();
}

TEST(AllocationCounter, CountsFromItsOwnBeginning) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer brings its own operator new";
  std::vector<int> before(5);
  const AllocationCounter counter;
  EXPECT_EQ(counter.count(), 0U) << before.size();
}

TEST(AllocationCounter, LeavesOtherThreadsOut) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer brings its own operator new";
  std::size_t inside = 0;
  std::thread other([&] {
    const AllocationCounter counter;
    std::vector<int> values(5);
    inside = counter.count() + values.size() - 5;
  });
  const AllocationCounter counter;
  other.join();
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_EQ(inside, 1U);
}

}  // namespace
}  // namespace somato::testing

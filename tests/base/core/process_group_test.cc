#include "somato/core/process_group.h"

#include <gtest/gtest.h>

#include <mutex>
#include <vector>

#include "base/support/thread_group.h"

namespace somato {
namespace {

using testing::in_thread_group;

TEST(ProcessGroupThreads, AgreeOnTheFirstFailure) {
  std::mutex mutex;
  std::vector<Error> errors;
  in_thread_group(4, [&](ProcessGroup& group) {
    EXPECT_TRUE(group.agree({}));
    const bool fails = group.rank() >= 2;
    const Result<void> own =
        fails ? fail(ErrorKind::kSystem, "broken " + std::to_string(group.rank()), "é", "repair it")
              : Result<void>();
    const Result<void> agreed = group.agree(own);
    ASSERT_FALSE(agreed);
    const std::scoped_lock lock(mutex);
    errors.push_back(agreed.error());
  });
  ASSERT_EQ(errors.size(), 4U);
  for (const Error& error : errors) {
    EXPECT_EQ(error.kind, ErrorKind::kSystem);
    EXPECT_EQ(to_string(error), "é: broken 2; repair it");
  }
}

TEST(ProcessGroupThreads, GatherNumbersAndTakeTurnsInOrder) {
  in_thread_group(3, [](ProcessGroup& group) {
    EXPECT_EQ(group.is_first(), group.rank() == 0);
    EXPECT_EQ(group.gather(static_cast<std::int64_t>(group.rank()) - 1),
              (std::vector<std::int64_t>{-1, 0, 1}));
    EXPECT_EQ(group.sum_before(static_cast<std::int64_t>(group.rank()) + 5),
              (std::vector<std::int64_t>{0, 5, 11}[group.rank()]));
    // ((1 * 2 + 0) * 2 + 1) * 2 + 2: another order gives another number.
    EXPECT_EQ(
        group.in_turn(
            1.0, [&](double value) { return value * 2.0 + static_cast<double>(group.rank()); }),
        12.0);
  });
}

}  // namespace
}  // namespace somato

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "studies/measures/paper_measures.h"

namespace somato {
namespace {

using LimitNumbers = std::vector<double>;
using LimitGroups = std::vector<std::size_t>;

// Whether each group is in one piece of the ring: as many changes as groups, or none.
bool is_in_pieces(const std::vector<std::size_t>& ring, const LimitGroups& groups) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    changes += groups[ring[i]] != groups[ring[(i + 1) % ring.size()]] ? 1 : 0;
  }
  LimitGroups different = groups;
  std::sort(different.begin(), different.end());
  const auto count = std::unique(different.begin(), different.end()) - different.begin();
  return changes == (count == 1 ? 0 : static_cast<std::size_t>(count));
}

// All orders around a circle.
OrderLimits limits_by_trying(const LimitNumbers& numbers, const LimitGroups& groups) {
  std::vector<std::size_t> ring(numbers.size());
  std::iota(ring.begin(), ring.end(), std::size_t{0});
  OrderLimits best{-1.0, -1.0, numbers.size()};
  do {
    if (!is_in_pieces(ring, groups)) continue;
    std::vector<MappedIndividual> placed;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(ring.size());
      placed.push_back({numbers[ring[i]], groups[ring[i]], {std::cos(angle), std::sin(angle)}});
    }
    const CircularOrder order = circular_order(placed);
    best.around = std::max(best.around, order.around);
    best.within = std::max(best.within, order.within);
    best.exceptions_around = std::min(best.exceptions_around, order.exceptions_around);
  } while (std::next_permutation(ring.begin(), ring.end()));
  return best;
}

// One group can be in order around the map; two that do not overlap as well, with either size
// first.
TEST(OrderLimits, AreWholeWhereTheNumbersDoNotOverlap) {
  for (const LimitGroups& groups : {LimitGroups{0, 0, 0, 0, 0, 0}, LimitGroups{0, 0, 0, 1, 1, 1},
                                    LimitGroups{1, 1, 0, 0, 0, 1}, LimitGroups{2, 2, 7, 7, 4, 4}}) {
    const auto limits = order_limits({1, 2, 3, 4, 5, 6}, groups);
    ASSERT_TRUE(limits);
    EXPECT_DOUBLE_EQ(limits->around, 1.0);
    EXPECT_EQ(limits->exceptions_around, 0U);
  }
}

// 1 3 and 2 4: 1 | 2 4 | 3 has the squared differences 1 + 1, and 4 must be taken away.
TEST(OrderLimits, AreThoseOfFourByHand) {
  const auto limits = order_limits({1, 3, 2, 4}, {0, 0, 1, 1});
  ASSERT_TRUE(limits);
  EXPECT_DOUBLE_EQ(limits->around, 0.8);
  EXPECT_EQ(limits->exceptions_around, 1U);
  EXPECT_EQ(limits->within, 0.0);
}

// objects/lucs3.toml. 0.877 was found by an enumeration of the 14,400 arrangements in NumPy, and so
// were three exceptions.
TEST(OrderLimits, ExcludeABoundOfTheObjectsOfHand3) {
  const auto limits =
      order_limits({40, 50, 60, 70, 80, 50, 60, 70, 80, 90}, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1});
  ASSERT_TRUE(limits);
  EXPECT_NEAR(limits->around, 0.877, 0.0005);
  EXPECT_DOUBLE_EQ(limits->within, 1.0);
  EXPECT_EQ(limits->exceptions_around, 3U);
}

TEST(OrderLimits, AreTheBestOfAllArrangements) {
  Random random(3, Stream::kSizeOrder);
  for (int problem = 0; problem < 25; ++problem) {
    const std::size_t count = 3 + random.below(4);
    const std::size_t kinds = 1 + random.below(3);
    LimitNumbers numbers;
    LimitGroups groups;
    for (std::size_t i = 0; i < count; ++i) {
      numbers.push_back(static_cast<double>(random.below(6)));
      groups.push_back(random.below(kinds));
    }
    const auto limits = order_limits(numbers, groups);
    if (!limits) continue;  // all numbers are equal
    const OrderLimits tried = limits_by_trying(numbers, groups);
    EXPECT_NEAR(limits->around, tried.around, 1e-12) << problem;
    EXPECT_NEAR(limits->within, tried.within, 1e-12) << problem;
    EXPECT_EQ(limits->exceptions_around, tried.exceptions_around) << problem;
  }
}

TEST(OrderLimits, AreNoneOfEqualNumbersAndOfManyGroups) {
  EXPECT_FALSE(order_limits({3}, {0}));
  EXPECT_FALSE(order_limits({3, 3, 3}, {0, 1, 0}));
  EXPECT_FALSE(order_limits({1, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(order_limits({1, 2, 3, 4, 5}, {0, 1, 2, 3, 4}));
}

TEST(OrderLimits, RefuseWhatHasNoOrder) {
  EXPECT_THROW((void)order_limits({}, {}), InvalidArgument);
  EXPECT_THROW((void)order_limits({1, 2}, {0}), InvalidArgument);
  EXPECT_THROW((void)order_limits({1, std::numeric_limits<double>::quiet_NaN()}, {0, 0}),
               InvalidArgument);
}

}  // namespace
}  // namespace somato

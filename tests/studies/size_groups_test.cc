#include "somato/studies/size_groups.h"

#include <gtest/gtest.h>

#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Classes = std::vector<std::size_t>;

// Cylinders (0) of 40, 55, 60, 62, 80, blocks (1) of 70, 30, 50, 90.
TEST(SizeGroups, PartEachGroupAtItsMedian) {
  EXPECT_EQ(size_groups(
                {{60, 0}, {70, 1}, {40, 0}, {55, 0}, {30, 1}, {80, 0}, {50, 1}, {62, 0}, {90, 1}}),
            (Classes{1, 3, 0, 0, 2, 1, 2, 1, 3}));
}

TEST(SizeGroups, NeverPartEqualNumbers) {
  EXPECT_EQ(size_groups({{1, 0}, {2, 0}, {2, 0}, {2, 0}, {3, 0}}), (Classes{0, 1, 1, 1, 1}));
  EXPECT_EQ(size_groups({{1, 0}, {1, 0}, {1, 0}, {2, 0}}), (Classes{1, 1, 1, 1}));
}

TEST(SizeGroups, OfOneOrNone) {
  EXPECT_EQ(size_groups({{7, 4}}), Classes{9});
  EXPECT_TRUE(size_groups({}).empty());
}

TEST(SizeGroups, RefuseNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)size_groups({{nan, 0}}), InvalidArgument);
}

// Large is who has more than half of the group, itself among them, at or below it.
TEST(SizeGroups, AgreeWithCounting) {
  Random random(41);
  for (int run = 0; run < 300; ++run) {
    std::vector<NumberedIndividual> individuals;
    const std::size_t count = 1 + random.below(12);
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = static_cast<double>(random.below(9));
      individuals.push_back({number, random.below(3)});
    }
    const Classes found = size_groups(individuals);
    ASSERT_EQ(found.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t members = 0;
      std::size_t not_larger = 0;
      for (const NumberedIndividual& other : individuals) {
        if (other.group != individuals[i].group) continue;
        ++members;
        not_larger += other.number <= individuals[i].number ? 1 : 0;
      }
      const bool large = not_larger > members / 2;
      EXPECT_EQ(found[i], 2 * individuals[i].group + (large ? 1 : 0)) << run;
    }
  }
}

}  // namespace
}  // namespace somato

#include "studies/measures/most_similar.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Found = std::vector<std::vector<std::size_t>>;
using Flags = std::vector<bool>;
using Things = std::vector<SizedThing>;

constexpr std::size_t kCylinder = 0;
constexpr std::size_t kBlock = 1;

// Cylinders of 40, 60 and 70 mm, blocks of 50 and 65.
const Things kKnown{{40, kCylinder}, {50, kBlock}, {60, kCylinder}, {65, kBlock}, {70, kCylinder}};

TEST(MostSimilar, AreOfTheSameGroupAndNearestInNumber) {
  EXPECT_EQ(most_similar(kKnown, {{51, kCylinder}, {49, kCylinder}, {64, kCylinder}, {1, kBlock}}),
            (Found{{2}, {0}, {2}, {1}}));
}

TEST(MostSimilar, AreAllInATie) {
  EXPECT_EQ(most_similar(kKnown, {{50, kCylinder}, {65, kCylinder}}), (Found{{0, 2}, {2, 4}}));
  EXPECT_EQ(most_similar({{3, 0}, {3, 0}}, {{3, 0}}), (Found{{0, 1}}));
}

// In binary 0.3 is nearer to 0.2 than to 0.4.
TEST(MostSimilar, AreTiedDespiteRounding) {
  EXPECT_EQ(most_similar({{0.2, 0}, {0.4, 0}}, {{0.3, 0}}), (Found{{0, 1}}));
  EXPECT_EQ(most_similar({{0.2, 0}, {0.4, 0}}, {{0.300001, 0}}), (Found{{1}}));
}

TEST(MostSimilar, AreNoneWithoutTheGroup) {
  EXPECT_EQ(most_similar(kKnown, {{50, 2}, {40, kCylinder}}), (Found{{}, {0}}));
  EXPECT_EQ(most_similar({}, {{50, 2}}), Found{{}});
  EXPECT_TRUE(most_similar(kKnown, {}).empty());
}

TEST(MostSimilar, RefusesNumbersThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)most_similar({{infinity, 0}}, {{1, 0}}), InvalidArgument);
  EXPECT_THROW((void)most_similar({{1, 0}}, {{-infinity, 0}}), InvalidArgument);
}

// In whole tenths of a millimetre: a known one is most similar when no other is nearer.
TEST(MostSimilar, AgreeWithWholeNumbers) {
  Random random(31);
  for (int run = 0; run < 500; ++run) {
    std::vector<long> tenths;
    Things known;
    for (std::size_t i = 0; i < 8; ++i) {
      tenths.push_back(static_cast<long>(random.below(60)) - 20);
      known.push_back({static_cast<double>(tenths.back()) / 10.0, random.below(3)});
    }
    const long target = static_cast<long>(random.below(60)) - 20;
    const std::size_t group = random.below(3);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < known.size(); ++i) {
      bool is_nearest = known[i].group == group;
      for (std::size_t j = 0; j < known.size(); ++j) {
        const bool nearer = std::labs(tenths[j] - target) < std::labs(tenths[i] - target);
        if (known[j].group == group && nearer) is_nearest = false;
      }
      if (is_nearest) expected.push_back(i);
    }
    EXPECT_EQ(most_similar(known, {{static_cast<double>(target) / 10.0, group}})[0], expected);
  }
}

// Cylinders (0) of 40, 55, 60, 62, 80, blocks (1) of 70, 30, 50, 90.
TEST(IsLarge, PartsEachGroupAtItsMedian) {
  EXPECT_EQ(
      is_large({{60, 0}, {70, 1}, {40, 0}, {55, 0}, {30, 1}, {80, 0}, {50, 1}, {62, 0}, {90, 1}}),
      (Flags{true, true, false, false, false, true, false, true, true}));
}

TEST(IsLarge, NeverPartsEqualNumbers) {
  EXPECT_EQ(is_large({{1, 0}, {2, 0}, {2, 0}, {2, 0}, {3, 0}}),
            (Flags{false, true, true, true, true}));
  EXPECT_EQ(is_large({{1, 0}, {1, 0}, {1, 0}, {2, 0}}), (Flags{true, true, true, true}));
}

TEST(IsLarge, IsTheOnlyOne) {
  EXPECT_EQ(is_large({{7, 4}}), Flags{true});
  EXPECT_TRUE(is_large({}).empty());
}

TEST(IsLarge, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)is_large({{nan, 0}}), InvalidArgument);
}

// Large is who has more than half of the group, itself among them, at or below it.
TEST(IsLarge, AgreesWithCounting) {
  Random random(41);
  for (int run = 0; run < 300; ++run) {
    std::vector<SizedThing> things;
    const std::size_t count = 1 + random.below(12);
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = static_cast<double>(random.below(9));
      things.push_back({number, random.below(3)});
    }
    const Flags found = is_large(things);
    ASSERT_EQ(found.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t members = 0;
      std::size_t not_larger = 0;
      for (const SizedThing& other : things) {
        if (other.group != things[i].group) continue;
        ++members;
        not_larger += other.number <= things[i].number ? 1 : 0;
      }
      const bool large = not_larger > members / 2;
      EXPECT_EQ(found[i], large) << run;
    }
  }
}

}  // namespace
}  // namespace somato

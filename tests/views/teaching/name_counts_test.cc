#include "views/teaching/name_counts.h"

#include <gtest/gtest.h>

namespace somato::live {
namespace {

class NameCountsTest : public ::testing::Test {};

TEST_F(NameCountsTest, KeepsTheOrderOfFirstUseForEachLabel) {
  NameCounts counts;
  for (const char* name : {"cup", "unknown", "ball", "cup"}) counts.add({"object", name});
  counts.add({"material", "wood"});
  EXPECT_EQ(counts.of("object"), (std::vector<NameCount>{{"cup", 2}, {"ball", 1}}));
  EXPECT_EQ(counts.of("material"), (std::vector<NameCount>{{"wood", 1}}));
  counts.remove({"object", "cup"});
  counts.remove({"object", "cup"});
  EXPECT_EQ(counts.of("object"), (std::vector<NameCount>{{"cup", 0}, {"ball", 1}}))
      << "a name keeps its key";
  counts.remove({"object", "ball"});
  EXPECT_EQ(counts.of("object"), (std::vector<NameCount>{{"cup", 0}}))
      << "the last one does not, as after a misspelling";
}

TEST_F(NameCountsTest, ProposesTheFirstNameThatIsNotComplete) {
  NameCounts counts({"cup", "ball"}, 2);
  EXPECT_EQ(counts.next("object"), (NameCount{"cup", 1}));
  counts.add({"object", "ball"});
  counts.add({"object", "cup"});
  EXPECT_EQ(counts.next("object"), (NameCount{"cup", 2}));
  counts.add({"object", "cup"});
  EXPECT_EQ(counts.next("object"), (NameCount{"ball", 2}));
  counts.add({"object", "ball"});
  counts.add({"object", "sponge"});
  EXPECT_EQ(counts.next("object"), std::nullopt) << "a sponge is not planned";
  counts.plan(3);
  EXPECT_EQ(counts.next("object"), (NameCount{"cup", 3}));
  counts.plan(0);
  EXPECT_EQ(counts.next("object"), std::nullopt);
  for (int i = 0; i < 2; ++i) counts.remove({"object", "ball"});
  EXPECT_EQ(counts.of("object")[1], (NameCount{"ball", 0})) << "what is planned remains";
}

TEST_F(NameCountsTest, PlansAllNamesIfNoneIsGiven) {
  NameCounts counts;
  counts.plan(1);
  EXPECT_EQ(counts.next("object"), std::nullopt);
  counts.add({"object", "cup"});
  EXPECT_EQ(counts.next("object"), std::nullopt);
  counts.plan(2);
  EXPECT_EQ(counts.next("object"), (NameCount{"cup", 2}));
}

}  // namespace
}  // namespace somato::live

#include "studies/measures/wrong_groupings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

Numbers one_each(std::size_t count) {
  Numbers individuals(count);
  for (std::size_t i = 0; i < count; ++i) individuals[i] = i;
  return individuals;
}

// Which samples are together, whatever the classes are called.
std::set<std::set<std::size_t>> partition(const Numbers& classes) {
  std::map<std::size_t, std::set<std::size_t>> members;
  for (std::size_t i = 0; i < classes.size(); ++i) members[classes[i]].insert(i);
  std::set<std::set<std::size_t>> parts;
  for (const auto& [its_class, samples] : members) parts.insert(samples);
  return parts;
}

// The number of individuals of each class.
std::map<std::size_t, std::size_t> sizes(const Numbers& classes, const Numbers& individuals) {
  std::map<std::size_t, std::set<std::size_t>> members;
  for (std::size_t i = 0; i < classes.size(); ++i) members[classes[i]].insert(individuals[i]);
  std::map<std::size_t, std::size_t> counts;
  for (const auto& [its_class, its_individuals] : members) {
    counts[its_class] = its_individuals.size();
  }
  return counts;
}

bool keeps_individuals_together(const Numbers& classes, const Numbers& individuals) {
  std::map<std::size_t, std::size_t> class_of;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (class_of.emplace(individuals[i], classes[i]).first->second != classes[i]) return false;
  }
  return true;
}

void expect_wrong(const Numbers& classes, const Numbers& individuals, std::uint64_t seed) {
  const auto groupings = wrong_groupings(classes, individuals, 30, seed);
  ASSERT_EQ(groupings.size(), 30U);
  for (const Numbers& grouping : groupings) {
    ASSERT_EQ(grouping.size(), classes.size());
    EXPECT_EQ(sizes(grouping, individuals), sizes(classes, individuals));
    EXPECT_TRUE(keeps_individuals_together(grouping, individuals));
    EXPECT_NE(partition(grouping), partition(classes));
  }
}

TEST(WrongGroupings, KeepSizesAndIndividualsAndAreNeverRight) {
  Random random(1);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    // Individuals 1, 8, 15, ...: two of class 3, then one or two each of some classes more.
    Numbers class_of_individual{3, 3};
    for (std::size_t its_class = 4; its_class < 6 + random.below(3); ++its_class) {
      class_of_individual.insert(class_of_individual.end(), 1 + random.below(2), its_class);
    }
    Numbers classes;
    Numbers individuals;
    for (int sample = 0; sample < 40; ++sample) {
      const std::size_t individual =
          sample < 10 ? static_cast<std::size_t>(sample) % class_of_individual.size()
                      : random.below(class_of_individual.size());
      classes.push_back(class_of_individual[individual]);
      individuals.push_back(1 + 7 * individual);
    }
    expect_wrong(classes, individuals, seed);
  }
}

// Two classes of equal size: half of all dealings are the right one or the right one renamed.
TEST(WrongGroupings, DoNotTakeAnotherNameForAnotherGrouping) {
  expect_wrong({0, 0, 1, 1}, one_each(4), 3);
}

// Six objects in three pairs can be paired in 15 ways.
TEST(WrongGroupings, ReachAllWrongPairingsOfSixObjects) {
  const Numbers pairs{0, 0, 1, 1, 2, 2};
  std::map<std::set<std::set<std::size_t>>, int> drawn;
  for (const Numbers& grouping : wrong_groupings(pairs, one_each(6), 1400, 5)) {
    ++drawn[partition(grouping)];
  }
  EXPECT_EQ(drawn.size(), 14U);
  // 100 of each are expected, with a standard deviation of less than 10.
  for (const auto& [pairing, count] : drawn) {
    EXPECT_GT(count, 50);
    EXPECT_LT(count, 150);
  }
}

TEST(WrongGroupings, AreAFunctionOfTheSeed) {
  const Numbers classes{0, 0, 0, 1, 1, 1, 2, 2};
  EXPECT_EQ(wrong_groupings(classes, one_each(8), 10, 4),
            wrong_groupings(classes, one_each(8), 10, 4));
  EXPECT_NE(wrong_groupings(classes, one_each(8), 10, 4),
            wrong_groupings(classes, one_each(8), 10, 5));
}

TEST(WrongGroupings, AreNoneWhereNoneIsPossible) {
  EXPECT_TRUE(wrong_groupings({1, 1, 1}, one_each(3), 10, 1).empty());
  EXPECT_TRUE(wrong_groupings({0, 1, 2}, one_each(3), 10, 1).empty());
  EXPECT_TRUE(wrong_groupings({0, 0, 1, 1}, {5, 5, 6, 6}, 10, 1).empty());
  EXPECT_TRUE(wrong_groupings({0, 0, 1, 1}, one_each(4), 0, 1).empty());
}

TEST(WrongGroupings, RefuseAnIndividualOfTwoClasses) {
  EXPECT_THROW(wrong_groupings({0, 1, 1}, {4, 4, 5}, 1, 1), InvalidArgument);
  EXPECT_THROW(wrong_groupings({0, 1, 1}, {4, 5}, 1, 1), InvalidArgument);
}

}  // namespace
}  // namespace somato

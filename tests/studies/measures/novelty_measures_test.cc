#include "studies/measures/novelty_measures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<double>;

Values few_values(std::size_t count, Random& random) {
  Values values(count);
  for (double& value : values) value = static_cast<double>(random.below(6));  // with ties
  return values;
}

TEST(NoveltyMeasures, AreaIsTheShareOfOrderedPairs) {
  EXPECT_EQ(area_under_curve({1, 2}, {3}), 1.0);
  EXPECT_EQ(area_under_curve({1, 2}, {2}), 0.75);
  EXPECT_EQ(area_under_curve({1, 2}, {0}), 0.0);
  Random random(3);
  for (std::size_t trial = 0; trial < 50; ++trial) {
    const Values known = few_values(1 + random.below(9), random);
    const Values unknown = few_values(1 + random.below(9), random);
    double pairs = 0.0;
    for (const double a : known) {
      for (const double b : unknown) pairs += a < b ? 1.0 : a == b ? 0.5 : 0.0;
    }
    const auto all = static_cast<double>(known.size() * unknown.size());
    EXPECT_DOUBLE_EQ(area_under_curve(known, unknown), pairs / all);
  }
}

TEST(NoveltyMeasures, NoticedAtARateFollowFromTheLowestLimit) {
  Random random(4);
  for (std::size_t trial = 0; trial < 50; ++trial) {
    const Values known = few_values(1 + random.below(9), random);
    const Values unknown = few_values(1 + random.below(9), random);
    for (const double rate : {0.0, 0.05, 0.25, 0.5}) {
      const auto above = [](const Values& values, double limit) {
        const auto count = std::count_if(values.begin(), values.end(),
                                         [&](double value) { return value > limit; });
        return static_cast<double>(count) / static_cast<double>(values.size());
      };
      double best = 0.0;  // over all limits that are one of the known scores
      for (const double limit : known) {
        if (above(known, limit) <= rate) best = std::max(best, above(unknown, limit));
      }
      EXPECT_EQ(noticed_at(known, unknown, rate), best);
    }
  }
}

TEST(NoveltyMeasures, SharesAreThoseAboveOne) {
  EXPECT_EQ(share_unknown({0.5, 1.0, 1.5, 9.0}), 0.5);
}

TEST(NoveltyMeasures, NeedScores) {
  EXPECT_THROW((void)area_under_curve({}, {1}), InvalidArgument);
  EXPECT_THROW((void)area_under_curve({1}, {}), InvalidArgument);
  EXPECT_THROW((void)noticed_at({}, {1}, 0.05), InvalidArgument);
  EXPECT_THROW((void)noticed_at({1}, {}, 0.05), InvalidArgument);
  EXPECT_THROW((void)noticed_at({1}, {1}, 1.0), InvalidArgument);
  EXPECT_THROW((void)share_unknown({}), InvalidArgument);
}

TEST(NoveltyMeasures, FoldsArePooled) {
  NoveltyOutcome all{{{1}, {2}, {3}}, {{4}, {5}, {6}}};
  all.add({{{7}, {8}, {9}}, {{10}, {11}, {12}}});
  EXPECT_EQ(all, (NoveltyOutcome{{{1, 7}, {2, 8}, {3, 9}}, {{4, 10}, {5, 11}, {6, 12}}}));
}

}  // namespace
}  // namespace somato

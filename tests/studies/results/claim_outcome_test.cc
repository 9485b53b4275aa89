#include "somato/studies/claim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/studies/results.h"

namespace somato {
namespace {

// `holding` pairs of 1, then others of 0, for a claim of at least 1.
ClaimOutcome pairs_of_one(std::size_t holding, std::size_t others) {
  ClaimOutcome outcome;
  outcome.claim.metric = "classes_separated";
  outcome.claim.at_least = 1.0;
  outcome.values.assign(holding, 1.0);
  outcome.values.resize(holding + others, 0.0);
  return outcome;
}

TEST(ClaimVerdict, HoldsFrom95PercentOfThePairs) {
  EXPECT_EQ(pairs_of_one(19, 1).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs_of_one(95, 5).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs_of_one(94, 6).verdict(), ClaimVerdict::kMostly);
}

TEST(ClaimVerdict, IsMostlyFromHalfOfThePairs) {
  EXPECT_EQ(pairs_of_one(10, 10).verdict(), ClaimVerdict::kMostly);
  EXPECT_EQ(pairs_of_one(49, 51).verdict(), ClaimVerdict::kFails);
  EXPECT_EQ(pairs_of_one(0, 20).verdict(), ClaimVerdict::kFails);
}

TEST(ClaimVerdict, NeedsTwentyPairsWithAValue) {
  EXPECT_EQ(pairs_of_one(19, 0).verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(pairs_of_one(19, 0).reason(), "19 pairs; 20 are needed");
  EXPECT_EQ(pairs_of_one(0, 1).reason(), "1 pair; 20 are needed");
  EXPECT_EQ(pairs_of_one(20, 0).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs_of_one(20, 0).reason(), "");
  ClaimOutcome without = pairs_of_one(20, 0);
  without.values.back() = std::nan("");
  EXPECT_EQ(without.reason(), "19 pairs; 20 are needed");
  without.values.push_back(1.0);  // 20 of 21 pairs
  EXPECT_EQ(without.verdict(), ClaimVerdict::kHolds);
}

TEST(ClaimVerdict, SaysWhereChanceHoldsToo) {
  ClaimOutcome outcome = pairs_of_one(20, 0);
  outcome.chance_share = 0.5;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kHoldsByChanceToo);
  outcome.chance_share = 0.499;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kHolds);
  outcome = pairs_of_one(10, 10);
  outcome.chance_share = 1.0;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kMostly);
}

TEST(ClaimVerdict, IsUndecidedWhateverTheShareWhereTheExplorationsCannotDecide) {
  ClaimOutcome outcome = pairs_of_one(100, 0);
  outcome.undecidable = "no exploration of 'boccia'";
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(outcome.reason(), "no exploration of 'boccia'");
}

// Twenty counts from 1 to 20, of which the central range leaves out 1 and 20.
ClaimOutcome counts(double published, const ClaimRange& by_chance) {
  ClaimOutcome outcome = pairs_of_one(0, 0);
  outcome.claim.criterion = ClaimCriterion::kCentralRange;
  outcome.claim.published = published;
  for (int count = 1; count <= 20; ++count) outcome.values.push_back(count);
  outcome.chance_range = by_chance;
  return outcome;
}

TEST(ClaimVerdict, OfACountIsThatOfTheCentralRange) {
  EXPECT_EQ(counts(2, {0, 30}).range(), (ClaimRange{2, 19}));
  EXPECT_EQ(counts(2, {0, 30}).verdict(), ClaimVerdict::kCompatible);
  EXPECT_EQ(counts(19, {0, 30}).verdict(), ClaimVerdict::kCompatible);
  EXPECT_EQ(counts(1, {0, 30}).verdict(), ClaimVerdict::kFails);
  EXPECT_EQ(counts(20, {0, 30}).verdict(), ClaimVerdict::kFails);
}

TEST(ClaimVerdict, OfACountNeedsARangeNarrowerThanByChance) {
  EXPECT_EQ(counts(5, {0, 17.5}).verdict(), ClaimVerdict::kCompatible);
  EXPECT_EQ(counts(5, {0, 17}).verdict(), ClaimVerdict::kCompatibleByChanceToo);
  EXPECT_EQ(counts(5, {40, 41}).verdict(), ClaimVerdict::kCompatibleByChanceToo);
  EXPECT_EQ(counts(1, {40, 41}).verdict(), ClaimVerdict::kFails);
}

TEST(ClaimVerdict, OfACountNeedsChanceAPublishedValueAndAllPairs) {
  ClaimOutcome outcome = counts(5, {0, 30});
  outcome.chance_range.reset();
  EXPECT_EQ(outcome.reason(), "no values by chance");
  outcome = counts(5, {0, 30});
  outcome.claim.published.reset();
  EXPECT_EQ(outcome.reason(), "no published value");
  outcome = counts(5, {0, 30});
  outcome.values.push_back(std::nan(""));
  EXPECT_EQ(outcome.reason(), "1 of 21 pairs have no value");
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kUndecided);
  outcome.values.resize(19);
  EXPECT_EQ(outcome.reason(), "19 pairs; 20 are needed");
}

// Four recordings of five equal pairs: the quantile of three degrees of freedom is 3.182.
ClaimOutcome differences(const std::vector<double>& of_recordings, double at_least) {
  ClaimOutcome outcome;
  outcome.claim.criterion = ClaimCriterion::kMean;
  outcome.claim.at_least = at_least;
  for (std::size_t recording = 0; recording < of_recordings.size(); ++recording) {
    outcome.values.insert(outcome.values.end(), 5, of_recordings[recording]);
    outcome.recordings.insert(outcome.recordings.end(), 5, recording);
  }
  return outcome;
}

TEST(ClaimVerdict, OfAMeanIsThatOfItsInterval) {
  const std::vector<double> around_two{1, 2, 2, 3};  // 2 +- 3.182 * sqrt(2 / 3) / 2 = 2 +- 1.299
  EXPECT_NEAR(differences(around_two, 0.0).range()->low, 2.0 - 1.2992, 1e-3);
  EXPECT_EQ(differences(around_two, 0.0).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(differences(around_two, 0.7).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(differences(around_two, 0.8).verdict(), ClaimVerdict::kUndetermined);
  EXPECT_EQ(differences(around_two, 3.2).verdict(), ClaimVerdict::kUndetermined);
  EXPECT_EQ(differences(around_two, 3.4).verdict(), ClaimVerdict::kFails);
  ClaimOutcome below = differences(around_two, 0.0);
  below.claim.at_least.reset();
  below.claim.at_most = 3.4;
  EXPECT_EQ(below.verdict(), ClaimVerdict::kHolds);
  below.claim.at_most = 0.5;
  EXPECT_EQ(below.verdict(), ClaimVerdict::kFails);
}

// "At least as many" and "not more" are true of equal maps.
TEST(ClaimVerdict, OfAMeanAtABoundThatIsIncludedHolds) {
  ClaimOutcome equal = differences({0, 0, 0, 0}, 0.0);
  EXPECT_EQ(equal.verdict(), ClaimVerdict::kHolds);
  equal.claim.at_most = 0.0;
  EXPECT_EQ(equal.verdict(), ClaimVerdict::kHolds);
  equal.claim.at_least.reset();
  EXPECT_EQ(equal.verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(differences({-1, 1, -1, 1}, 0.0).verdict(), ClaimVerdict::kUndetermined);
  EXPECT_EQ(differences({-0.5, -0.5, -0.5, -0.5}, 0.0).verdict(), ClaimVerdict::kFails);
}

// No difference in any pair is not a better one.
TEST(ClaimVerdict, OfAMeanAtABoundThatIsNotIncludedIsNotDetermined) {
  ClaimOutcome equal = differences({0, 0, 0, 0}, 0.0);
  equal.claim.bounds_included = false;
  EXPECT_EQ(equal.verdict(), ClaimVerdict::kUndetermined);
  equal.claim.at_least.reset();
  equal.claim.at_most = 0.0;
  EXPECT_EQ(equal.verdict(), ClaimVerdict::kUndetermined);
  ClaimOutcome better = differences({0.5, 0.5, 0.5, 0.5}, 0.0);
  better.claim.bounds_included = false;
  EXPECT_EQ(better.verdict(), ClaimVerdict::kHolds);
  better.claim.at_least = 0.6;
  EXPECT_EQ(better.verdict(), ClaimVerdict::kFails);
}

// The mean of 15 pairs of 1 and five of 5 is 2; that of the two recordings is 3.
TEST(ClaimOutcome, MeanIsTheCentreOfTheIntervalWithUnequalPairs) {
  ClaimOutcome outcome = differences({1, 1, 1, 5}, 0.0);
  for (std::size_t i = 0; i < 20; ++i) outcome.recordings[i] = i < 15 ? 3 : 8;
  EXPECT_DOUBLE_EQ(outcome.mean(), 3.0);
  EXPECT_NEAR((outcome.range()->low + outcome.range()->high) / 2.0, 3.0, 1e-9);
  EXPECT_NE(outcome.summary().find("mean 3.000"), std::string::npos);
  outcome.claim.criterion = ClaimCriterion::kShareOfPairs;
  EXPECT_DOUBLE_EQ(outcome.mean(), 2.0);
  outcome.claim.criterion = ClaimCriterion::kMean;
  outcome.recordings.clear();
  EXPECT_DOUBLE_EQ(outcome.mean(), 2.0);
  outcome.values.clear();
  EXPECT_TRUE(std::isnan(outcome.mean()));
}

TEST(ClaimVerdict, OfAMeanNeedsTwoRecordingsAndAllPairs) {
  ClaimOutcome outcome = differences({1, 2, 2, 3}, 0.0);
  outcome.recordings.assign(20, 4);
  EXPECT_EQ(outcome.reason(), "1 recording; 2 are needed");
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kUndecided);
  outcome.recordings.clear();
  EXPECT_EQ(outcome.reason(), "the recordings of the pairs are unknown");
  outcome = differences({1, 2, 2, 3, std::nan("")}, 0.0);
  EXPECT_EQ(outcome.reason(), "5 of 25 pairs have no value");
  EXPECT_FALSE(outcome.range());
  EXPECT_EQ(differences({1, 2, 3}, 0.0).reason(), "15 pairs; 20 are needed");
}

// Over both pairs the values by chance are 0 ten times and 1 to 10 once each: one is left out at
// either end.
TEST(Claim, ChanceRangeIsOfTheWrongGroupingsOfAllPairs) {
  Metric by_chance{"classes_separated_chance", {0.0, 5.5}, {{{0.0, 10}}, {}}};
  for (int value = 1; value <= 10; ++value) by_chance.of_each[1][value] = 1;
  EXPECT_EQ(chance_range_of(by_chance), (ClaimRange{0, 9}));
  by_chance.of_each.clear();
  EXPECT_FALSE(chance_range_of(by_chance));
}

TEST(ClaimVerdict, HasItsNames) {
  EXPECT_EQ(choice_name(ClaimVerdict::kHolds), "holds");
  EXPECT_EQ(choice_name(ClaimVerdict::kHoldsByChanceToo), "holds, but so does chance");
  EXPECT_EQ(choice_name(ClaimVerdict::kMostly), "mostly");
  EXPECT_EQ(choice_name(ClaimVerdict::kFails), "fails");
  EXPECT_EQ(choice_name(ClaimVerdict::kUndecided), "cannot be decided here");
}

// In the first pair 3 of 4 wrong groupings lie within 4 to 6, in the second 1 of 4.
TEST(Claim, ChanceIsTheMeanShareOfWrongGroupingsWithinTheBounds) {
  Claim claim;
  claim.at_least = 4.0;
  claim.at_most = 6.0;
  Metric by_chance{"classes_separated_chance",
                   {5.0, 6.0},
                   {{{4.0, 2}, {5.0, 1}, {7.0, 1}}, {{3.0, 1}, {6.0, 1}, {8.0, 2}}}};
  EXPECT_EQ(chance_share_of(claim, by_chance), 0.5);
  by_chance.of_each.clear();
  EXPECT_FALSE(chance_share_of(claim, by_chance));
}

TEST(ClaimOutcome, HasASummary) {
  ClaimOutcome outcome = counts(5, {0, 30});
  EXPECT_EQ(
      outcome.summary(),
      "classes_separated range with 5: mean 10.500, central 90 % 2.00 to 19.00, by chance 0.00 "
      "to 30.00, 100 % of the pairs");
  outcome = differences({2, 2, 2, 2}, 0.0);
  outcome.claim.metric = "accuracy";
  EXPECT_EQ(
      outcome.summary(),
      "accuracy at least 0: mean 2.000, interval of the mean 2.00 to 2.00, 100 % of the pairs");
  outcome.recordings.clear();
  outcome.claim.bounds_included = false;
  EXPECT_EQ(outcome.summary(), "accuracy above 0: mean 2.000, 100 % of the pairs");
  outcome.values.clear();
  EXPECT_EQ(outcome.summary(), "accuracy above 0");
}

TEST(ReasonUndecidable, IsABoundAboveTheExplorationsOrAThingThatIsNotThere) {
  ProtocolResults system;
  system.samples = 8;
  system.runs = {{1, {}, {"boule", "cube"}, {}, {}}};
  Claim claim;
  claim.metric = "shape.neighbours_same_class";
  claim.at_least = 8.0;
  EXPECT_EQ(reason_undecidable(claim, system), "");
  claim.at_least = 29.0;
  EXPECT_EQ(reason_undecidable(claim, system), "8 explorations; 29 are needed");
  claim.metric = "quantization_error";  // counts no explorations
  EXPECT_EQ(reason_undecidable(claim, system), "");
  claim.at_least = 1.0;
  claim.metric = "mapped_with boule cube";
  EXPECT_EQ(reason_undecidable(claim, system), "");
  claim.metric = "mapped_with boccia cube";
  EXPECT_EQ(reason_undecidable(claim, system), "no exploration of 'boccia'");
  claim.metric = "mapped_with cube boccia";
  EXPECT_EQ(reason_undecidable(claim, system), "no exploration of 'boccia'");
  system.runs.clear();
  EXPECT_EQ(reason_undecidable(claim, system), "");
}

}  // namespace
}  // namespace somato

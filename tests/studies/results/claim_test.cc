#include "somato/studies/claim.h"

#include <gtest/gtest.h>

#include "somato/studies/results.h"

#include <cmath>

#include "base/files/toml_file.h"

namespace somato {
namespace {

Result<std::vector<Claim>> claims(const std::string& toml) {
  return read_claims(parse_toml(toml, "system.toml").value());
}

void expect_refused(const std::string& toml, const std::string& message) {
  const auto read = claims(toml);
  ASSERT_FALSE(read) << message;
  EXPECT_EQ(read.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(read.error()), message);
}

double share(const std::optional<double>& at_least, const std::optional<double>& at_most,
             const std::vector<double>& values) {
  Claim claim;
  claim.at_least = at_least;
  claim.at_most = at_most;
  return ClaimOutcome{claim, values, {}}.share();
}

TEST(ReadClaims, ReadsEveryKeyAndTheDefaults) {
  const auto read = claims(R"([study]
name = "s"

[[claim]]
text = "Wood and plastic are separated."
paper = "P11 IV-F"
system = "texture"
variation = "wide"
metric = "classes_separated"
protocol = "leave_group_out"
group = "trial"
than_system = "hardness"
than_variation = "narrow"
than_metric = "shape.classes_separated_chance"
published = 3.5
at_least = 1
at_most = 7.5

[[claim]]
text = "Most are named."
metric = "accuracy"
at_most = 0.5
)");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  const Claim& first = read->at(0);
  EXPECT_EQ(first.text, "Wood and plastic are separated.");
  EXPECT_EQ(first.paper, "P11 IV-F");
  EXPECT_EQ(first.system, "texture");
  EXPECT_EQ(first.variation, "wide");
  EXPECT_EQ(first.metric, "classes_separated");
  EXPECT_EQ(first.protocol, "leave_group_out");
  EXPECT_EQ(first.group, "trial");
  EXPECT_EQ(first.than_system, "hardness");
  EXPECT_EQ(first.than_variation, "narrow");
  EXPECT_EQ(first.than_metric, "shape.classes_separated_chance");
  EXPECT_EQ(first.published, 3.5);
  EXPECT_EQ(first.at_least, 1.0);
  EXPECT_EQ(first.at_most, 7.5);
  EXPECT_EQ(first.where, "system.toml:4");
  EXPECT_TRUE(first.compares());
  const Claim& second = read->at(1);
  EXPECT_EQ(second.protocol, "train_is_test");
  EXPECT_EQ(second.where, "system.toml:19");
  EXPECT_FALSE(second.published);
  EXPECT_FALSE(second.at_least);
  EXPECT_FALSE(second.compares());
}

TEST(ReadClaims, AreNoneInAFileWithoutThem) {
  EXPECT_TRUE(claims("[study]\nname = 's'\n")->empty());
}

TEST(ReadClaims, RefusesWhatCannotHoldAtItsLine) {
  expect_refused("claim = 3\n",
                 "system.toml:1: 'claim' must be a list of tables; write each claim as a separate "
                 "table [[claim]]");
  expect_refused("[claim]\ntext = 't'\n",
                 "system.toml:1: 'claim' must be a list of tables; write each claim as a separate "
                 "table [[claim]]");
  expect_refused("\n[[claim]]\nmetric = 'accuracy'\nat_least = 0\n",
                 "system.toml:2: the claim has no text; add text = \"...\"");
  expect_refused("[[claim]]\ntext = 't'\nat_least = 0\n",
                 "system.toml:1: the claim has no metric; add metric = \"accuracy\"");
  expect_refused("[[claim]]\ntext = 't'\nmetric = 'accuracy'\n",
                 "system.toml:1: the claim has no bound; add at_least = ... or at_most = ...");
  expect_refused("[[claim]]\ntext = 't'\nmetrics = 'accuracy'\n",
                 "system.toml:3: unknown key 'metrics'; did you mean 'metric'?");
  expect_refused(
      "[[claim]]\ntext = 't'\nmetric = 'accuracy'\nthan_metric = 'baseline_acuracy'\nat_least = "
      "0\n",
      "system.toml:1: unknown metric 'baseline_acuracy'; did you mean 'baseline_accuracy'?");
}

TEST(Claim, ComparesWithAnotherSystemVariationOrMetric) {
  Claim claim;
  EXPECT_FALSE(claim.compares());
  claim.than_variation = "wide";
  EXPECT_TRUE(claim.compares());
  claim.than_variation.clear();
  claim.than_system = "hardness";
  EXPECT_TRUE(claim.compares());
  claim.than_system.clear();
  claim.than_metric = "baseline_accuracy";
  EXPECT_TRUE(claim.compares());
}

TEST(Claim, SubtractsTheSameMetricUnlessAnotherIsNamed) {
  Claim claim;
  claim.metric = "accuracy";
  EXPECT_EQ(claim.other_metric(), "accuracy");
  claim.than_metric = "baseline_accuracy";
  EXPECT_EQ(claim.other_metric(), "baseline_accuracy");
}

TEST(Claim, SaysWhatIsMeasured) {
  Claim claim;
  claim.system = "texture";
  claim.metric = "accuracy";
  EXPECT_EQ(claim.other(), "");
  EXPECT_EQ(claim.measured(), "accuracy");
  claim.than_variation = "small";
  EXPECT_EQ(claim.measured(), "accuracy less that of small");
  claim.than_system = "hardness";
  EXPECT_EQ(claim.measured(), "accuracy less that of hardness, small");
  claim.than_variation.clear();
  claim.than_metric = "baseline_accuracy";
  EXPECT_EQ(claim.other(), "hardness");
  EXPECT_EQ(claim.measured(), "accuracy less baseline_accuracy of hardness");
}

TEST(Claim, HoldsWithinItsBounds) {
  EXPECT_EQ(share(0.5, {}, {0.25, 0.5, 0.75, 1.0}), 0.75);
  EXPECT_EQ(share({}, 0.5, {0.25, 0.5, 0.75, 1.0}), 0.5);
  EXPECT_EQ(share(0.5, 0.75, {0.25, 0.5, 0.75, 1.0}), 0.5);
  EXPECT_EQ(share(2.0, 1.0, {1.0, 1.5, 2.0}), 0.0);
}

// 0.3 - 0.1 is a rounding error below 0.2, and 0.1 + 0.2 one above 0.3.
TEST(Claim, IsNotFailedByRounding) {
  ASSERT_LT(0.3 - 0.1, 0.2);
  ASSERT_GT(0.1 + 0.2, 0.3);
  EXPECT_EQ(share(0.2, {}, {0.3 - 0.1}), 1.0);
  EXPECT_EQ(share({}, 0.3, {0.1 + 0.2}), 1.0);
  EXPECT_EQ(share(0.2, 0.2, {0.199, 0.201}), 0.0);
}

TEST(Claim, OfNoPairsHoldsInNone) {
  EXPECT_EQ(share(0.0, {}, {}), 0.0);
}

// `holding` pairs of 1, then others of 0, for a claim of at least 1.
ClaimOutcome pairs(std::size_t holding, std::size_t others) {
  ClaimOutcome outcome;
  outcome.claim.metric = "classes_separated";
  outcome.claim.at_least = 1.0;
  outcome.values.assign(holding, 1.0);
  outcome.values.resize(holding + others, 0.0);
  return outcome;
}

TEST(ClaimVerdict, HoldsFrom95PercentOfThePairs) {
  EXPECT_EQ(pairs(19, 1).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs(95, 5).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs(94, 6).verdict(), ClaimVerdict::kMostly);
}

TEST(ClaimVerdict, IsMostlyFromHalfOfThePairs) {
  EXPECT_EQ(pairs(10, 10).verdict(), ClaimVerdict::kMostly);
  EXPECT_EQ(pairs(49, 51).verdict(), ClaimVerdict::kFails);
  EXPECT_EQ(pairs(0, 20).verdict(), ClaimVerdict::kFails);
}

TEST(ClaimVerdict, NeedsTwentyPairsWithAValue) {
  EXPECT_EQ(pairs(19, 0).verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(pairs(19, 0).reason(), "19 pairs; 20 are needed");
  EXPECT_EQ(pairs(0, 1).reason(), "1 pair; 20 are needed");
  EXPECT_EQ(pairs(20, 0).verdict(), ClaimVerdict::kHolds);
  EXPECT_EQ(pairs(20, 0).reason(), "");
  ClaimOutcome without = pairs(20, 0);
  without.values.back() = std::nan("");
  EXPECT_EQ(without.reason(), "19 pairs; 20 are needed");
  without.values.push_back(1.0);  // 20 of 21 pairs
  EXPECT_EQ(without.verdict(), ClaimVerdict::kHolds);
}

TEST(ClaimVerdict, SaysWhereChanceHoldsToo) {
  ClaimOutcome outcome = pairs(20, 0);
  outcome.chance_share = 0.5;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kHoldsByChanceToo);
  outcome.chance_share = 0.499;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kHolds);
  outcome = pairs(10, 10);
  outcome.chance_share = 1.0;
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kMostly);
}

TEST(ClaimVerdict, IsUndecidedWhateverTheShareWhereTheExplorationsCannotDecide) {
  ClaimOutcome outcome = pairs(100, 0);
  outcome.undecidable = "no exploration of 'boccia'";
  EXPECT_EQ(outcome.verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(outcome.reason(), "no exploration of 'boccia'");
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

TEST(Claim, SaysItsBounds) {
  Claim claim;
  claim.at_least = 4.0;
  EXPECT_EQ(claim.bounds(), "at least 4");
  claim.at_most = 6.5;
  EXPECT_EQ(claim.bounds(), "between 4 and 6.5");
  claim.at_least.reset();
  EXPECT_EQ(claim.bounds(), "at most 6.5");
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

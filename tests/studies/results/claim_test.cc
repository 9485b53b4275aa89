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

TEST(ReadClaims, ReadsTheKeysOfTheSecondMeasure) {
  const auto read = claims(R"([[claim]]
text = "Five are separated."
metric = "classes_separated"
published = 5
at_least = 4
judged_by = "central_range"
contradicted_by = "P11 Fig. 8"

[[claim]]
text = "They are in order."
metric = "order_around"
at_least = 0.9
judged_metric = "exceptions_around"
judged_at_most = 1
)");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->at(0).judged_by, ClaimCriterion::kCentralRange);
  EXPECT_EQ(read->at(0).contradicted_by, "P11 Fig. 8");
  EXPECT_EQ(read->at(1).judged_by, ClaimCriterion::kShareOfPairs);
  EXPECT_EQ(read->at(1).judged_metric, "exceptions_around");
  EXPECT_EQ(read->at(1).judged_at_most, 1.0);
}

TEST(ReadClaims, RefusesASecondMeasureThatIsIncomplete) {
  const std::string claim = "[[claim]]\ntext = 't'\nmetric = 'accuracy'\nat_least = 0\n";
  expect_refused(claim + "judged_metric = 'order_around'\n",
                 "system.toml:1: 'judged_metric' has no bound; add judged_at_least or "
                 "judged_at_most");
  expect_refused(claim + "judged_metric = 'order_arond'\njudged_at_least = 1\n",
                 "system.toml:1: unknown metric 'order_arond'; did you mean 'order_around'?");
  expect_refused(claim + "judged_by = 'central_range'\n",
                 "system.toml:1: a central range needs a published value; add published = ...");
  const std::string range = claim + "published = 1\njudged_by = 'central_range'\n";
  const std::string refused =
      "system.toml:1: a central range is of one metric, without other bounds; use judged_by = "
      "\"mean\" for a comparison, and remove the bounds";
  expect_refused(range + "than_system = 'texture'\n", refused);
  expect_refused(range + "judged_at_most = 2\n", refused);
  const auto unknown = claims(claim + "judged_by = 'median'\n");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().where, "system.toml:5");
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

TEST(Claim, HasASecondMeasureOnlyIfAKeyDeclaresIt) {
  Claim claim;
  claim.metric = "order_around";
  claim.published = 0.9;
  claim.at_least = 0.9;
  EXPECT_FALSE(claim.as_written());
  claim.judged_at_least = 0.5;
  EXPECT_EQ(claim.as_written()->at_least, 0.5);
  EXPECT_EQ(claim.as_written()->published, 0.9);
  claim.judged_at_least.reset();
  claim.judged_by = ClaimCriterion::kMean;
  EXPECT_EQ(claim.as_written()->criterion, ClaimCriterion::kMean);
  EXPECT_EQ(claim.as_written()->at_least, 0.9);
  EXPECT_TRUE(claim.as_written()->bounds_included);
  claim.judged_metric = "exceptions_around";
  claim.judged_at_most = 1.0;
  const Claim second = claim.as_written().value();
  EXPECT_EQ(second.metric, "exceptions_around");
  EXPECT_FALSE(second.published);
  EXPECT_FALSE(second.at_least);
  EXPECT_EQ(second.at_most, 1.0);
  EXPECT_FALSE(second.bounds_included);
  EXPECT_FALSE(second.as_written());
  claim.judged_by = ClaimCriterion::kShareOfPairs;
  EXPECT_TRUE(claim.as_written()->bounds_included);
  EXPECT_EQ(claim.criterion, ClaimCriterion::kShareOfPairs);
}

TEST(Claim, SaysItsBounds) {
  Claim claim;
  claim.at_least = 4.0;
  EXPECT_EQ(claim.bounds(), "at least 4");
  claim.at_most = 6.5;
  EXPECT_EQ(claim.bounds(), "between 4 and 6.5");
  claim.at_least.reset();
  EXPECT_EQ(claim.bounds(), "at most 6.5");
  claim.criterion = ClaimCriterion::kMean;
  EXPECT_EQ(claim.bounds(), "at most 6.5");
  claim.bounds_included = false;
  EXPECT_EQ(claim.bounds(), "below 6.5");
  claim.at_least = 0.0;
  EXPECT_EQ(claim.bounds(), "between 0 and 6.5");
  claim.at_most.reset();
  EXPECT_EQ(claim.bounds(), "above 0");
  claim.bounds_included = true;
  EXPECT_EQ(claim.bounds(), "at least 0");
  claim.criterion = ClaimCriterion::kCentralRange;
  claim.published = 5.0;
  EXPECT_EQ(claim.bounds(), "range with 5");
}

}  // namespace
}  // namespace somato

#include "somato/studies/claim.h"

#include <gtest/gtest.h>

#include "somato/files/toml_file.h"

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
text = "Wood is told from plastic."
paper = "P11 IV-F"
system = "texture"
variation = "wide"
metric = "told_exactly"
protocol = "leave_group_out"
group = "trial"
than_system = "hardness"
than_variation = "narrow"
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
  EXPECT_EQ(first.text, "Wood is told from plastic.");
  EXPECT_EQ(first.paper, "P11 IV-F");
  EXPECT_EQ(first.system, "texture");
  EXPECT_EQ(first.variation, "wide");
  EXPECT_EQ(first.metric, "told_exactly");
  EXPECT_EQ(first.protocol, "leave_group_out");
  EXPECT_EQ(first.group, "trial");
  EXPECT_EQ(first.than_system, "hardness");
  EXPECT_EQ(first.than_variation, "narrow");
  EXPECT_EQ(first.published, 3.5);
  EXPECT_EQ(first.at_least, 1.0);
  EXPECT_EQ(first.at_most, 7.5);
  EXPECT_EQ(first.where, "system.toml:4");
  EXPECT_TRUE(first.compares());
  const Claim& second = read->at(1);
  EXPECT_EQ(second.protocol, "train_is_test");
  EXPECT_EQ(second.where, "system.toml:18");
  EXPECT_FALSE(second.published);
  EXPECT_FALSE(second.at_least);
  EXPECT_FALSE(second.compares());
}

TEST(ReadClaims, AreNoneInAFileWithoutThem) {
  EXPECT_TRUE(claims("[study]\nname = 's'\n")->empty());
}

TEST(ReadClaims, RefusesWhatCannotHoldAtItsLine) {
  expect_refused("claim = 3\n",
                 "system.toml:1: claims are a list; write [[claim]] on a line of its own for each");
  expect_refused("[claim]\ntext = 't'\n",
                 "system.toml:1: claims are a list; write [[claim]] on a line of its own for each");
  expect_refused("\n[[claim]]\nmetric = 'accuracy'\nat_least = 0\n",
                 "system.toml:2: a claim needs its text; add text = \"...\"");
  expect_refused("[[claim]]\ntext = 't'\nat_least = 0\n",
                 "system.toml:1: a claim needs a metric; add metric = \"accuracy\"");
  expect_refused("[[claim]]\ntext = 't'\nmetric = 'accuracy'\n",
                 "system.toml:1: a claim needs a bound; add at_least = ... or at_most = ...");
  expect_refused("[[claim]]\ntext = 't'\nmetrics = 'accuracy'\n",
                 "system.toml:3: unknown key 'metrics'; did you mean 'metric'?");
}

TEST(Claim, ComparesWithAnotherSystemOrVariation) {
  Claim claim;
  EXPECT_FALSE(claim.compares());
  claim.than_variation = "wide";
  EXPECT_TRUE(claim.compares());
  claim.than_variation.clear();
  claim.than_system = "hardness";
  EXPECT_TRUE(claim.compares());
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

}  // namespace
}  // namespace somato

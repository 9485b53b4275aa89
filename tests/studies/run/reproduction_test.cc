#include "somato/studies/reproduction.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato {
namespace {

using Values = std::vector<double>;

// Two seeds under two protocols; every value identifies its origin.
PartResults found(double base, std::uint64_t first_seed = 7) {
  PartResults results;
  results.system = "small";
  results.study = "[study]";
  results.parameters = {{"study", {{"seeds", "2"}}}};
  results.recordings = {{"one", "given", 0, "hash", 2}};
  results.pairs = {{0, first_seed}, {0, first_seed + 1}};
  for (const std::string protocol : {"train_is_test", "leave_group_out"}) {
    ProtocolResults system;
    system.protocol = protocol;
    system.group = protocol == "leave_group_out" ? "trial" : "";
    system.label = "object";
    system.samples = 2;
    const double more = system.group.empty() ? 0.0 : 0.5;
    system.metrics = {{"accuracy", {base + more, base + more + 1}},
                      {"classes_separated", {10 * base, 10 * base + 2}},
                      {"classes_separated_chance", {base, base + 3}}};
    for (const std::uint64_t seed : {first_seed, first_seed + 1}) {
      system.runs.push_back({seed, {seed, 3}, {"ball", "cube"}, {"ball", "ball"}, {}});
    }
    results.protocols.push_back(std::move(system));
  }
  return results;
}

PartResults begun(const std::string& question, const std::string& system,
                  const std::string& variation) {
  PartResults results;
  results.question = question;
  results.system = system;
  results.variation = variation;
  return results;
}

PartResults part(const std::string& question, const std::string& system,
                 const std::string& variation, double base) {
  PartResults results = begun(question, system, variation);
  EXPECT_TRUE(add_results(found(base), results));
  EXPECT_TRUE(add_results(found(base + 100, 9), results));
  return results;
}

Claim claim(const std::string& system, const std::string& metric, double at_least) {
  Claim made;
  made.text = "text";
  made.system = system;
  made.metric = metric;
  made.at_least = at_least;
  return made;
}

TEST(PairsOf, SumToThePairsAndAreAsEqualAsCanBe) {
  for (std::size_t recordings = 1; recordings < 9; ++recordings) {
    for (std::size_t pairs = 1; pairs < 30; ++pairs) {
      std::size_t sum = 0;
      for (std::size_t recording = 0; recording < recordings; ++recording) {
        const std::size_t of_this = pairs_of(recording, recordings, pairs);
        const std::size_t of_first = pairs_of(0, recordings, pairs);
        EXPECT_LE(of_this, of_first);
        EXPECT_LE(of_first - of_this, 1U);
        sum += of_this;
      }
      EXPECT_EQ(sum, pairs) << recordings;
    }
  }
  EXPECT_EQ(pairs_of(0, 6, 100), 17U);
  EXPECT_EQ(pairs_of(3, 6, 100), 17U);
  EXPECT_EQ(pairs_of(4, 6, 100), 16U);
}

TEST(AddResults, PutsPairsOneAfterTheOther) {
  const PartResults all = part("", "small", "", 1);
  ASSERT_EQ(all.pairs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(all.pairs[i].recording, i / 2);
    EXPECT_EQ(all.pairs[i].seed, 7 + i);
  }
  ASSERT_EQ(all.protocols.size(), 2U);
  EXPECT_EQ(all.protocols[0].metrics[0].values, (Values{1, 2, 101, 102}));
  EXPECT_EQ(all.protocols[0].metrics[1].values, (Values{10, 12, 1010, 1012}));
  EXPECT_EQ(all.protocols[1].metrics[0].values, (Values{1.5, 2.5, 101.5, 102.5}));
  for (const ProtocolResults& protocol : all.protocols) {
    ASSERT_EQ(protocol.runs.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(protocol.runs[i].seed, 7 + i);
  }
  ASSERT_EQ(all.parameters.size(), 1U);
  EXPECT_EQ(all.parameters[0].part, "study");
  EXPECT_EQ(all.study, "[study]");
  EXPECT_EQ(all.recordings.size(), 2U);
  EXPECT_TRUE(all.test_recordings.empty());
}

void expect_misfit(const PartResults& second) {
  PartResults results = begun("", "small", "");
  ASSERT_TRUE(add_results(found(1), results));
  const auto added = add_results(second, results);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().kind, ErrorKind::kData);
  EXPECT_FALSE(added.error().advice.empty());
  // Nothing of it is in.
  EXPECT_EQ(results.pairs.size(), 2U);
  EXPECT_EQ(results.recordings.size(), 1U);
  for (const ProtocolResults& protocol : results.protocols) {
    EXPECT_EQ(protocol.runs.size(), 2U);
    for (const Metric& metric : protocol.metrics) EXPECT_EQ(metric.values.size(), 2U);
  }
}

TEST(AddResults, RefusesWhatWasMeasuredOtherwise) {
  PartResults misfit = found(2);
  misfit.protocols.pop_back();
  expect_misfit(misfit);
  misfit = found(2);
  misfit.protocols[1].protocol = "leave_one_out";
  expect_misfit(misfit);
  misfit = found(2);
  misfit.protocols[1].group = "site";
  expect_misfit(misfit);
  misfit = found(2);
  misfit.protocols[1].metrics.pop_back();
  expect_misfit(misfit);
  misfit = found(2);
  misfit.protocols[1].metrics[0].name = "shape.accuracy";
  expect_misfit(misfit);
  PartResults results;
  EXPECT_THROW((void)add_results(PartResults{}, results), InvalidArgument);
}

TEST(Judge, LooksAtEveryPairUnderItsProtocol) {
  const std::vector<PartResults> parts{part("", "small", "", 1), part("", "small", "wide", 5)};
  std::vector<Claim> claims{claim("small", "accuracy", 101), claim("small", "accuracy", 7),
                            claim("small", "accuracy", 102.5)};
  claims[1].variation = "wide";
  claims[2].protocol = "leave_group_out";
  claims[2].group = "trial";
  const auto outcomes = judge(claims, parts);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].values, (Values{1, 2, 101, 102}));
  EXPECT_EQ(outcomes[0].share(), 0.5);
  EXPECT_EQ(outcomes[1].values, (Values{5, 6, 105, 106}));
  EXPECT_EQ(outcomes[2].values, (Values{1.5, 2.5, 101.5, 102.5}));
  EXPECT_EQ(outcomes[2].share(), 0.25);
  for (const ClaimOutcome& outcome : outcomes) EXPECT_FALSE(outcome.by_chance);
}

// By by_chance: 1, 4, 101 and 104.
TEST(Judge, ComparesWithChance) {
  const auto outcomes =
      judge({claim("small", "classes_separated", 11)}, {part("", "small", "", 1)});
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].by_chance, 52.5);
  EXPECT_EQ(outcomes[0].share(), 0.75);
}

// Bounds from 1 to 10 on pairs of 10, 12, 1010 and 1012. Three of four wrong groupings have 2 and
// one has 98: their mean of 26 is beyond the bounds, and most of them are within.
TEST(Judge, CountsTheWrongGroupingsWithinTheBounds) {
  PartResults results = part("", "small", "", 1);
  Metric& by_chance = results.protocols[0].metrics[2];
  by_chance.values.assign(4, 26.0);
  by_chance.of_each.assign(4, {{2.0, 3}, {98.0, 1}});
  Claim within = claim("small", "classes_separated", 1);
  within.at_most = 10.0;
  EXPECT_EQ(judge({within}, {results}).at(0).chance_share, 0.75);
  Claim compared = within;
  compared.than_system = "small";
  EXPECT_FALSE(judge({compared}, {results}).at(0).chance_share);
}

TEST(AddResults, PutsWrongGroupingsOneAfterTheOther) {
  PartResults first = found(1);
  first.protocols[0].metrics[2].of_each = {{{1.0, 2}}, {{4.0, 2}}};
  PartResults second = found(2);
  second.protocols[0].metrics[2].of_each = {{{2.0, 2}}, {{5.0, 2}}};
  PartResults results = begun("", "small", "");
  ASSERT_TRUE(add_results(first, results));
  ASSERT_TRUE(add_results(second, results));
  EXPECT_EQ(results.protocols[0].metrics[2].of_each,
            (std::vector<Distribution>{{{1.0, 2}}, {{4.0, 2}}, {{2.0, 2}}, {{5.0, 2}}}));
}

TEST(Judge, ListsWhatTheExplorationsCannotDecide) {
  const auto outcomes = judge({claim("small", "classes_separated", 3)}, {part("", "small", "", 1)});
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].reason(), "2 explorations; 3 are needed");
}

TEST(Judge, ComparesPairByPair) {
  PartResults other = part("", "other", "", 1);
  other.protocols[0].metrics[0].values = {0, 2, 100.5, 110};
  Claim better = claim("small", "accuracy", 0.5);
  better.than_system = "other";
  Claim than_itself = claim("small", "classes_separated", 0);
  than_itself.variation = "wide";
  than_itself.than_system = "small";
  const auto outcomes =
      judge({better, than_itself}, {part("", "small", "", 1), other, part("", "small", "wide", 3)});
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_EQ(outcomes[0].values, (Values{1, 0, 0.5, -8}));
  EXPECT_EQ(outcomes[0].share(), 0.5);
  EXPECT_FALSE(outcomes[0].by_chance);
  EXPECT_EQ(outcomes[1].values, (Values{20, 20, 20, 20}));
  EXPECT_FALSE(outcomes[1].by_chance);
}

// Accuracies of 1, 2, 101 and 102 less 20, 22, 1020 and 1022 separated classes of the other part.
TEST(Judge, ComparesDifferentMetrics) {
  Claim claimed = claim("small", "accuracy", -20);
  claimed.than_system = "small";
  claimed.than_variation = "wide";
  claimed.than_metric = "classes_separated";
  const PartResults other = part("", "small", "wide", 2);
  const auto outcomes = judge({claimed}, {part("", "small", "", 1), other});
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].values, (Values{-19, -20, -919, -920}));
  EXPECT_EQ(outcomes[0].share(), 0.5);
  claimed.than_metric = "topographic_error";
  EXPECT_TRUE(judge({claimed}, {part("", "small", "", 1), other}).empty());
}

// The second measure of a claim has its metric, bounds, chance and recordings.
TEST(Judge, AddsTheSecondMeasure) {
  PartResults results = part("", "small", "", 1);
  ProtocolResults& protocol = results.protocols[0];
  protocol.metrics[2].of_each.assign(4, {{2.0, 3}, {98.0, 1}});
  protocol.metrics.push_back({"classes_separated_greatest", {8, 8, 8, 8}});
  Claim claimed = claim("small", "accuracy", 101);
  claimed.judged_metric = "classes_separated";
  claimed.judged_at_most = 12.0;
  const ClaimOutcome outcome = judge({claimed}, {results}).at(0);
  EXPECT_EQ(outcome.share(), 0.5);
  EXPECT_FALSE(outcome.limit);
  ASSERT_EQ(outcome.as_written.size(), 1U);
  const ClaimOutcome& second = outcome.as_written[0];
  EXPECT_EQ(second.values, (Values{10, 12, 1010, 1012}));
  EXPECT_EQ(second.share(), 0.5);
  EXPECT_EQ(second.chance_share, 0.75);
  EXPECT_EQ(second.chance_range, (ClaimRange{2, 98}));
  EXPECT_EQ(second.limit, 8.0);
  EXPECT_EQ(second.recordings, (std::vector<std::size_t>{0, 0, 1, 1}));
  EXPECT_TRUE(judge({claim("small", "accuracy", 101)}, {results}).at(0).as_written.empty());
}

// A second measure is not left out, so that no total counts the first verdict in its place.
TEST(Judge, SaysThatTheMetricOfTheSecondMeasureWasNotMeasured) {
  const PartResults results = part("", "small", "", 1);
  Claim claimed = claim("small", "accuracy", 101);
  claimed.judged_metric = "topographic_error";
  claimed.judged_at_most = 0.5;
  const ClaimOutcome second = judge({claimed}, {results}).at(0).as_written.at(0);
  EXPECT_EQ(second.verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(second.reason(), "the metric 'topographic_error' was not measured");
  EXPECT_EQ(second.claim.metric, "topographic_error");
  EXPECT_TRUE(second.values.empty());
  PartResults wide = part("", "small", "wide", 1);
  wide.protocols[0].metrics.pop_back();
  claimed.than_system = "small";
  claimed.than_variation = "wide";
  claimed.judged_metric = "classes_separated_chance";  // of the first one only
  EXPECT_EQ(judge({claimed}, {results, wide}).at(0).as_written.at(0).reason(),
            "the metric 'classes_separated_chance' was not measured");
}

// Pairs that share a recording on either side are not independent.
TEST(Judge, HasTheRecordingsOfTheSystemWithFewer) {
  PartResults other = part("", "other", "", 2);
  other.recordings.resize(1);
  for (Pair& pair : other.pairs) pair.recording = 0;
  Claim claimed = claim("small", "accuracy", 0);
  claimed.than_system = "other";
  claimed.judged_by = ClaimCriterion::kMean;
  const std::vector<PartResults> parts{part("", "small", "", 1), other};
  EXPECT_EQ(judge({claimed}, parts).at(0).as_written.at(0).recordings,
            (std::vector<std::size_t>{0, 0, 0, 0}));
  std::swap(claimed.system, claimed.than_system);
  EXPECT_EQ(judge({claimed}, parts).at(0).as_written.at(0).recordings,
            (std::vector<std::size_t>{0, 0, 0, 0}));
}

TEST(Judge, KeepsQuestionsApart) {
  const std::vector<PartResults> parts{part("", "small", "", 1), part("why", "small", "", 2)};
  Claim questioned = claim("small", "accuracy", 0);
  questioned.question = "why";
  EXPECT_EQ(judge({questioned}, parts).at(0).values, (Values{2, 3, 102, 103}));
  EXPECT_EQ(judge({claim("small", "accuracy", 0)}, parts).at(0).values, (Values{1, 2, 101, 102}));
}

TEST(Judge, LeavesOutWhatWasNotRun) {
  std::vector<Claim> claims{claim("other", "accuracy", 0),  // no such system
                            claim("small", "accuracy", 0),  // no such variation
                            claim("small", "shape.accuracy", 0),
                            claim("small", "accuracy", 0),   // no such protocol
                            claim("small", "accuracy", 0),   // no such group
                            claim("small", "accuracy", 0),   // nothing to compare with
                            claim("small", "accuracy", 0)};  // other pairs
  claims[1].variation = "wide";
  claims[3].protocol = "leave_one_out";
  claims[4].protocol = "leave_group_out";
  claims[5].than_system = "other";
  claims[6].than_system = "fewer";
  PartResults fewer = begun("", "fewer", "");
  ASSERT_TRUE(add_results(found(1), fewer));
  const std::vector<PartResults> parts{part("", "small", "", 1), fewer};
  EXPECT_TRUE(judge(claims, parts).empty());
  EXPECT_EQ(judge({claim("small", "accuracy", 0)}, parts).size(), 1U);
}

}  // namespace
}  // namespace somato

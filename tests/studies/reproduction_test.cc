#include "somato/studies/reproduction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "somato/core/check.h"

namespace somato {
namespace {

using Json = nlohmann::json;
using Values = std::vector<double>;

// Two seeds under two protocols; every value tells where it comes from.
StudyResults found(double base, std::uint64_t first_seed = 7) {
  StudyResults results;
  results.study = "small";
  results.seeds = 2;
  results.settings = {{"study", {{"seeds", "2"}}}};
  for (const std::string protocol : {"train_is_test", "leave_group_out"}) {
    SystemResults system;
    system.name = "small";
    system.protocol = protocol;
    system.group = protocol == "leave_group_out" ? "trial" : "";
    system.label = "object";
    system.samples = 2;
    const double more = system.group.empty() ? 0.0 : 0.5;
    system.metrics = {{"accuracy", {base + more, base + more + 1}},
                      {"told_exactly", {10 * base, 10 * base + 2}},
                      {"told_exactly_by_luck", {base, base + 3}}};
    for (const std::uint64_t seed : {first_seed, first_seed + 1}) {
      system.runs.push_back({seed, {seed, 3}, {"ball", "cube"}, {"ball", "ball"}, {}});
    }
    results.systems.push_back(std::move(system));
  }
  return results;
}

PartResults part(const std::string& question, const std::string& system,
                 const std::string& variation, double base) {
  PartResults results{question, system, variation, {"one", "two"}, {}, {}, {}};
  EXPECT_TRUE(add_results(found(base), 0, results));
  EXPECT_TRUE(add_results(found(base + 100, 9), 1, results));
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
  for (const SystemResults& protocol : all.protocols) {
    ASSERT_EQ(protocol.runs.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(protocol.runs[i].seed, 7 + i);
  }
  ASSERT_EQ(all.settings.size(), 1U);
  EXPECT_EQ(all.settings[0].part, "study");
}

void expect_misfit(const StudyResults& second) {
  PartResults results{"", "small", "", {}, {}, {}, {}};
  ASSERT_TRUE(add_results(found(1), 0, results));
  const auto added = add_results(second, 1, results);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().kind, ErrorKind::kData);
  EXPECT_FALSE(added.error().advice.empty());
  // Nothing of it is in.
  EXPECT_EQ(results.pairs.size(), 2U);
  for (const SystemResults& protocol : results.protocols) {
    EXPECT_EQ(protocol.runs.size(), 2U);
    for (const Metric& metric : protocol.metrics) EXPECT_EQ(metric.values.size(), 2U);
  }
}

TEST(AddResults, RefusesWhatWasMeasuredOtherwise) {
  StudyResults misfit = found(2);
  misfit.systems.pop_back();
  expect_misfit(misfit);
  misfit = found(2);
  misfit.systems[1].protocol = "leave_one_out";
  expect_misfit(misfit);
  misfit = found(2);
  misfit.systems[1].group = "site";
  expect_misfit(misfit);
  misfit = found(2);
  misfit.systems[1].metrics.pop_back();
  expect_misfit(misfit);
  misfit = found(2);
  misfit.systems[1].metrics[0].name = "shape.accuracy";
  expect_misfit(misfit);
  PartResults results;
  EXPECT_THROW((void)add_results(StudyResults{}, 0, results), InvalidArgument);
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
  for (const ClaimOutcome& outcome : outcomes) EXPECT_FALSE(outcome.by_luck);
}

// By luck: 1, 4, 101 and 104.
TEST(Judge, SetsWhatLuckGivesBesideIt) {
  const auto outcomes = judge({claim("small", "told_exactly", 11)}, {part("", "small", "", 1)});
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].by_luck, 52.5);
  EXPECT_EQ(outcomes[0].share(), 0.75);
}

// Bounds from 1 to 10 on pairs of 10, 12, 1010 and 1012. Three of four wrong groupings have 2 and
// one has 98: their mean of 26 is beyond the bounds, and most of them are within.
TEST(Judge, CountsTheWrongGroupingsWithinTheBounds) {
  PartResults results = part("", "small", "", 1);
  Metric& luck = results.protocols[0].metrics[2];
  luck.values.assign(4, 26.0);
  luck.of_each.assign(4, {{2.0, 3}, {98.0, 1}});
  Claim within = claim("small", "told_exactly", 1);
  within.at_most = 10.0;
  EXPECT_EQ(judge({within}, {results}).at(0).chance_share, 0.75);
  Claim compared = within;
  compared.than_system = "small";
  EXPECT_FALSE(judge({compared}, {results}).at(0).chance_share);
}

TEST(AddResults, PutsWrongGroupingsOneAfterTheOther) {
  StudyResults first = found(1);
  first.systems[0].metrics[2].of_each = {{{1.0, 2}}, {{4.0, 2}}};
  StudyResults second = found(2);
  second.systems[0].metrics[2].of_each = {{{2.0, 2}}, {{5.0, 2}}};
  PartResults results{"", "small", "", {}, {}, {}, {}};
  ASSERT_TRUE(add_results(first, 0, results));
  ASSERT_TRUE(add_results(second, 1, results));
  EXPECT_EQ(results.protocols[0].metrics[2].of_each,
            (std::vector<Distribution>{{{1.0, 2}}, {{4.0, 2}}, {{2.0, 2}}, {{5.0, 2}}}));
}

TEST(Judge, ListsWhatTheExplorationsCannotDecide) {
  const auto outcomes = judge({claim("small", "told_exactly", 3)}, {part("", "small", "", 1)});
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].reason(), "2 explorations; 3 are needed");
}

TEST(Judge, ComparesPairByPair) {
  PartResults other = part("", "other", "", 1);
  other.protocols[0].metrics[0].values = {0, 2, 100.5, 110};
  Claim better = claim("small", "accuracy", 0.5);
  better.than_system = "other";
  Claim than_itself = claim("small", "told_exactly", 0);
  than_itself.variation = "wide";
  than_itself.than_system = "small";
  const auto outcomes =
      judge({better, than_itself}, {part("", "small", "", 1), other, part("", "small", "wide", 3)});
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_EQ(outcomes[0].values, (Values{1, 0, 0.5, -8}));
  EXPECT_EQ(outcomes[0].share(), 0.5);
  EXPECT_FALSE(outcomes[0].by_luck);
  EXPECT_EQ(outcomes[1].values, (Values{20, 20, 20, 20}));
  EXPECT_FALSE(outcomes[1].by_luck);
}

TEST(Judge, KeepsQuestionsApart) {
  const std::vector<PartResults> parts{part("", "small", "", 1), part("why", "small", "", 2)};
  Claim asked = claim("small", "accuracy", 0);
  asked.question = "why";
  EXPECT_EQ(judge({asked}, parts).at(0).values, (Values{2, 3, 102, 103}));
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
  PartResults fewer{"", "fewer", "", {}, {}, {}, {}};
  ASSERT_TRUE(add_results(found(1), 0, fewer));
  const std::vector<PartResults> parts{part("", "small", "", 1), fewer};
  EXPECT_TRUE(judge(claims, parts).empty());
  EXPECT_EQ(judge({claim("small", "accuracy", 0)}, parts).size(), 1U);
}

class ReproductionJson : public ::testing::Test {
 protected:
  ReproductionJson() {
    results_.seed = 2011;
    results_.pairs = 4;
    results_.recordings = {{"one", "given", 0, "fnv1a64:01", 2}, {"two", "seed 5", 5, "x", 3}};
    results_.parts = {part("", "small", "", 1), part("why", "small", "wide", 2)};
    Claim compared = claim("small", "accuracy", 0.5);
    compared.paper = "P11";
    compared.published = 1.25;
    compared.at_most = 3.0;
    compared.than_system = "small";
    results_.claims = {{claim("small", "told_exactly", 11), {10, 12, 14, 16}, 52.5, 0.25},
                       {compared, {0.25, 0.75}, {}}};
    results_.not_applicable = {{"texture", "no channel 'sound'"}};
  }

  ReproductionResults results_;
};

TEST_F(ReproductionJson, HasEveryWinnerAndValueOfEveryPair) {
  const Json json = Json::parse(to_json(results_));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["seed"], 2011);
  EXPECT_EQ(json["pairs"], 4);
  ASSERT_EQ(json["systems"].size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& system = json["systems"][i];
    const PartResults& expected = results_.parts[i];
    EXPECT_EQ(system["question"], expected.question);
    EXPECT_EQ(system["system"], "small");
    EXPECT_EQ(system["variation"], expected.variation);
    EXPECT_EQ(system["recordings"], Json({"one", "two"}));
    EXPECT_EQ(system["settings"], Json::parse(R"({"study": {"seeds": 2}})"));
    EXPECT_EQ(system["pairs"], Json::parse("[[0, 7], [0, 8], [1, 9], [1, 10]]"));
    ASSERT_EQ(system["protocols"].size(), 2U);
    for (std::size_t p = 0; p < 2; ++p) {
      const Json& protocol = system["protocols"][p];
      EXPECT_EQ(protocol["protocol"], expected.protocols[p].protocol);
      for (const Metric& metric : expected.protocols[p].metrics) {
        EXPECT_EQ(protocol["metrics"][metric.name]["values"], Json(metric.values));
        EXPECT_EQ(protocol["metrics"][metric.name]["mean"], metric.mean());
      }
      for (std::size_t run = 0; run < 4; ++run) {
        EXPECT_EQ(protocol["runs"][run]["seed"], 7 + run);
        EXPECT_EQ(protocol["runs"][run]["winners"], Json({7 + run, 3}));
        EXPECT_EQ(protocol["runs"][run]["predictions"], Json({"ball", "ball"}));
      }
    }
    EXPECT_FALSE(system["protocols"][0].contains("group"));
    EXPECT_EQ(system["protocols"][1]["group"], "trial");
  }
}

// Mean of 10, 12, 14 and 16: 13; squared differences 9 + 1 + 1 + 9 = 20, by 3.
TEST_F(ReproductionJson, HasTheClaimsAndWhatTheyRestOn) {
  const Json json = Json::parse(to_json(results_));
  ASSERT_EQ(json["claims"].size(), 2U);
  EXPECT_DOUBLE_EQ(json["claims"][0]["sd"], std::sqrt(20.0 / 3.0));
  Json plain = json["claims"][0];
  plain.erase("sd");
  EXPECT_EQ(plain, Json::parse(R"({"text": "text", "paper": "", "question": "", "system": "small",
      "variation": "", "metric": "told_exactly", "protocol": "train_is_test", "group": "",
      "published": null, "at_least": 11.0, "at_most": null, "share": 0.75, "mean": 13.0,
      "verdict": "cannot be decided here", "reason": "4 pairs; 20 are needed",
      "by_luck": 52.5, "chance_share": 0.25, "pairs": 4})"));
  const Json& compared = json["claims"][1];
  EXPECT_EQ(compared["than_system"], "small");
  EXPECT_EQ(compared["than_variation"], "");
  EXPECT_EQ(compared["published"], 1.25);
  EXPECT_EQ(compared["at_most"], 3.0);
  EXPECT_EQ(compared["share"], 0.5);
  EXPECT_TRUE(compared["by_luck"].is_null());
  EXPECT_TRUE(compared["chance_share"].is_null());
}

TEST_F(ReproductionJson, NamesRecordingsAndWhatDoesNotApply) {
  const Json json = Json::parse(to_json(results_));
  EXPECT_EQ(json["recordings"], Json::parse(R"([
      {"name": "one", "source": "given", "seed": 0, "data_hash": "fnv1a64:01", "explorations": 2},
      {"name": "two", "source": "seed 5", "seed": 5, "data_hash": "x", "explorations": 3}])"));
  EXPECT_EQ(json["not_applicable"],
            Json::parse(R"([{"system": "texture", "reason": "no channel 'sound'"}])"));
  EXPECT_TRUE(to_json(results_).ends_with("}\n"));
}

TEST_F(ReproductionJson, OfNothingIsStillWhole) {
  const Json json = Json::parse(to_json(ReproductionResults{}));
  for (const char* list : {"recordings", "systems", "claims", "not_applicable"}) {
    EXPECT_EQ(json[list], Json::array()) << list;
  }
}

}  // namespace
}  // namespace somato

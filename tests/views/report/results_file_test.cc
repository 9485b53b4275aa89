#include "views/report/results_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/support/sanitized.h"
#include "somato/studies/reproduction.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

// Two parts on two recordings, with a claim that compares them.
Results made_results() {
  static const PartResults found =
      testing::outcome_of(testing::small_study(), testing::grasps(3, 4, 1)).results;
  Results all;
  for (const std::string variation : {"", "other"}) {
    PartResults part = found;
    part.variation = variation;
    part.recordings = {{"a.mcap", "lucs2, simulated", 5, "fnv1a64:0", 12},
                       {"b.mcap", "lucs2, simulated", 6, "fnv1a64:1", 12}};
    part.pairs = {{0, 5}, {1, 6}};
    if (variation.empty()) part.model = ModelFile{"systems/small.somato", "fnv1a64:2", 5};
    if (!variation.empty()) part.test_recordings = {part.recordings[1], part.recordings[0]};
    all.parts.push_back(std::move(part));
  }
  Claim claim;
  claim.text = "Nothing is lost";
  claim.system = "small";
  claim.than_system = "small";
  claim.than_variation = "other";
  claim.metric = "accuracy";
  claim.at_least = 0.0;
  claim.published = 0.25;
  Claim other_claim = claim;
  other_claim.metric = "classes_separated";
  other_claim.than_system.clear();
  other_claim.than_variation.clear();
  Claim of_two_metrics = claim;
  of_two_metrics.than_metric = "baseline_accuracy";
  of_two_metrics.judged_by = ClaimCriterion::kMean;
  of_two_metrics.judged_at_most = 0.5;
  of_two_metrics.contradicted_by = "P11 Fig. 8";
  all.claims = judge({claim, other_claim, of_two_metrics}, all.parts);
  all.not_applicable = {{"texture", "no sound"}};
  return all;
}

void expect_same(const Metric& a, const Metric& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.of_each, b.of_each);
}

void expect_same(const Run& a, const Run& b) {
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.winners, b.winners);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.predictions, b.predictions);
  EXPECT_EQ(a.other_predictions, b.other_predictions);
}

void expect_same(const std::vector<ProtocolResults>& a, const std::vector<ProtocolResults>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].protocol, b[i].protocol);
    EXPECT_EQ(a[i].group, b[i].group);
    EXPECT_EQ(a[i].label, b[i].label);
    EXPECT_EQ(a[i].samples, b[i].samples);
    ASSERT_EQ(a[i].metrics.size(), b[i].metrics.size());
    for (std::size_t m = 0; m < a[i].metrics.size(); ++m) {
      expect_same(a[i].metrics[m], b[i].metrics[m]);
    }
    ASSERT_EQ(a[i].runs.size(), b[i].runs.size());
    for (std::size_t r = 0; r < a[i].runs.size(); ++r) expect_same(a[i].runs[r], b[i].runs[r]);
  }
}

void expect_same(const std::vector<Settings>& a, const std::vector<Settings>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].part, b[i].part);
    ASSERT_EQ(a[i].settings.size(), b[i].settings.size());
    for (std::size_t s = 0; s < a[i].settings.size(); ++s) {
      EXPECT_EQ(a[i].settings[s].name, b[i].settings[s].name);
      EXPECT_EQ(a[i].settings[s].value, b[i].settings[s].value) << a[i].settings[s].name;
    }
  }
}

TEST(ResultsFile, ReadBackAsTheyWere) {
  const Results all = made_results();
  const auto read = parse_results(to_json(all), "results.json");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(to_json(*read), to_json(all));
  ASSERT_EQ(read->parts.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read->parts[i].study, all.parts[i].study);
    expect_same(read->parts[i].protocols, all.parts[i].protocols);
    expect_same(read->parts[i].parameters, all.parts[i].parameters);
    EXPECT_EQ(read->parts[i].recordings, all.parts[i].recordings);
    EXPECT_EQ(read->parts[i].test_recordings, all.parts[i].test_recordings);
    EXPECT_EQ(read->parts[i].pairs[1].recording, 1U);
    EXPECT_EQ(read->parts[i].pairs[1].seed, 6U);
  }
  ASSERT_TRUE(read->parts[0].model);
  EXPECT_EQ(read->parts[0].model->path, "systems/small.somato");
  EXPECT_EQ(read->parts[0].model->seed, 5U);
  EXPECT_FALSE(read->parts[1].model);
  ASSERT_FALSE(all.parts[0].protocols[0].find_metric("classes_separated_chance")->of_each.empty());
  ASSERT_EQ(read->claims.size(), 3U);
  EXPECT_TRUE(read->claims[1].chance_share);
  EXPECT_EQ(read->claims[1].chance_share, all.claims[1].chance_share);
  EXPECT_EQ(read->claims[1].reason(), "2 pairs; 20 are needed");
  EXPECT_EQ(read->claims[0].values, all.claims[0].values);
  EXPECT_EQ(read->claims[0].claim.published, 0.25);
  EXPECT_EQ(read->claims[0].claim.than_metric, "accuracy");
  EXPECT_EQ(read->claims[2].claim.than_metric, "baseline_accuracy");
  EXPECT_TRUE(read->claims[0].as_written.empty());
  EXPECT_EQ(read->claims[2].claim.contradicted_by, "P11 Fig. 8");
  const ClaimOutcome& second = read->claims[2].as_written.at(0);
  EXPECT_EQ(second.claim.criterion, ClaimCriterion::kMean);
  EXPECT_EQ(second.claim.at_most, 0.5);
  EXPECT_FALSE(second.claim.bounds_included);
  EXPECT_FALSE(second.claim.at_least);
  EXPECT_EQ(second.recordings, all.claims[2].as_written.at(0).recordings);
  EXPECT_EQ(second.range(), all.claims[2].as_written.at(0).range());
  EXPECT_EQ(second.verdict(), ClaimVerdict::kUndecided);
  EXPECT_EQ(read->not_applicable.at(0).reason, "no sound");
}

TEST(ResultsFile, ASecondMeasureThatWasNotMeasuredStays) {
  Results results = made_results();
  Claim claim = results.claims[0].claim;
  claim.judged_metric = "exceptions_around";
  claim.judged_at_most = 1.0;
  results.claims = judge({claim}, results.parts);
  const auto read = parse_results(to_json(results), "results.json");
  ASSERT_TRUE(read) << to_string(read.error());
  const ClaimOutcome& second = read->claims.at(0).as_written.at(0);
  EXPECT_EQ(second.reason(), "the metric 'exceptions_around' was not measured");
  EXPECT_TRUE(second.values.empty());
  EXPECT_TRUE(second.claim.bounds_included);
}

// JSON has no NaN: it stands as null.
TEST(ResultsFile, AMetricThatIsNoNumberStaysNone) {
  Results results = made_results();
  results.parts[0].protocols[0].metrics[0].values[1] = std::nan("");
  results.claims[0].values[1] = std::nan("");
  const auto read = parse_results(to_json(results), "results.json");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(std::isnan(read->parts[0].protocols[0].metrics[0].values[1]));
  EXPECT_TRUE(std::isnan(read->claims[0].values[1]));
}

// Version 3 of a study had `systems` by protocol, version 1 of a reproduction by part.
TEST(ResultsFile, OfAnEarlierVersionIsRefusedWithAdvice) {
  for (const std::string text : {R"({"version": 3, "study": "small", "systems": []})",
                                 R"({"version": 1, "systems": [], "claims": []})"}) {
    const auto read = parse_results(text, "old/results.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::kData);
    EXPECT_EQ(read.error().where, "old/results.json");
    EXPECT_NE(read.error().what.find("supported is 4"), std::string::npos);
    EXPECT_NE(read.error().advice.find("of this version again"), std::string::npos);
  }
}

Json& part_of(Json& json) {
  return json["parts"][0];
}

Json& protocol_of(Json& json) {
  return part_of(json)["protocols"][0];
}

Json& chance_of(Json& json) {
  return protocol_of(json)["metrics"]["classes_separated_chance"]["of_each"];
}

Json& map_of(Json& json) {
  return protocol_of(json)["runs"][1]["map"];
}

// The results of a map that grows, whose second map has three neurons in a row.
Results grown_results() {
  Results results = made_results();
  const auto graph =
      std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 1}, {1, 2}});
  for (Run& run : results.parts[0].protocols[0].runs) {
    std::fill(run.winners.begin(), run.winners.end(), 2);
    run.map = TrainedMap{Grid(graph), {0.5, 1.0, 1.5}, {0.5, 1.5}};
  }
  return results;
}

TEST(ResultsFile, MapsThatGrowAreReadBack) {
  const Results results = grown_results();
  const auto read = parse_results(to_json(results), "results.json");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->parts[0].protocols[0].runs[1].map, results.parts[0].protocols[0].runs[1].map);
}

// As results of this version before maps were stored.
TEST(ResultsFile, MapsMayBeMissing) {
  Json json = Json::parse(to_json(made_results()));
  protocol_of(json)["runs"][1].erase("map");
  const auto read = parse_results(json.dump(), "results.json");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(read->parts[0].protocols[0].runs[0].map);
  EXPECT_FALSE(read->parts[0].protocols[0].runs[1].map);
}

TEST(ResultsFile, ImpossibleGraphsAreRefused) {
  const Json whole = Json::parse(to_json(grown_results()));
  const std::vector<std::pair<Json, std::string>> edges{
      {Json::parse("[[0, 0], [1, 2]]"), "edges[0]' is not an edge"},
      {Json::parse("[[0, 1], [1, 3]]"), "edges[1]' is not an edge"},
      {Json::parse("[[0, 1], [0, 1]]"), "edges[1]' is not an edge"},
      {Json::parse("[[0, 1], [2, 1]]"), "edges[1]' is not an edge"},
      {Json::parse("[[0, 1, 2]]"), "edges[0]' has 3 entries"},
      {Json::parse("[[0, 1]]"), "edge_distances' has 2 entries"}};
  for (const auto& [damaged, words] : edges) {
    Json json = whole;
    map_of(json)["grid"]["edges"] = damaged;
    const auto read = parse_results(json.dump(), "results.json");
    ASSERT_FALSE(read) << damaged;
    EXPECT_NE(read.error().what.find(words), std::string::npos) << read.error().what;
  }
  Json json = whole;
  map_of(json)["grid"]["columns"] = 5000;
  EXPECT_FALSE(parse_results(json.dump(), "results.json"));
}

struct Damage {
  std::string name;
  std::function<void(Json&)> make;
  std::string says;
};

void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.name;
}

class DamagedResults : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedResults, AreRefusedWithFileAndField) {
  Json json = Json::parse(to_json(made_results()));
  GetParam().make(json);
  const auto read = parse_results(json.dump(), "some/results.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::kData);
  EXPECT_EQ(read.error().where, "some/results.json");
  EXPECT_FALSE(read.error().advice.empty());
  EXPECT_NE(read.error().what.find(GetParam().says), std::string::npos) << read.error().what;
}

const std::string kProtocol = "'parts[0].protocols[0].";

INSTANTIATE_TEST_SUITE_P(
    By, DamagedResults,
    ::testing::Values(
        Damage{"version", [](Json& j) { j["version"] = 5; },
               "written by a newer version of Somato (format 5, supported is 4)"},
        Damage{"version_text", [](Json& j) { j["version"] = "3"; }, "'version' is string"},
        Damage{"no_version", [](Json& j) { j.erase("version"); }, "not a results.json"},
        Damage{"no_parts", [](Json& j) { j.erase("parts"); }, "not a results.json"},
        Damage{"no_claims", [](Json& j) { j.erase("claims"); }, "'claims' is missing"},
        Damage{"system_number", [](Json& j) { part_of(j)["system"] = 7; }, "system' is number"},
        Damage{"no_study", [](Json& j) { part_of(j).erase("study"); }, "study' is missing"},
        Damage{"no_hash", [](Json& j) { j["recordings"][1].erase("hash"); },
               "'recordings[1].hash' is missing"},
        Damage{"parameters_list", [](Json& j) { part_of(j)["parameters"] = Json::array(); },
               "'parts[0].parameters'"},
        Damage{"parameter_number",
               [](Json& j) { part_of(j)["parameters"]["module.map"]["rows"] = 5; },
               "'parts[0].parameters.module.map.rows' is number"},
        Damage{"no_model", [](Json& j) { part_of(j).erase("model"); }, "model' is missing"},
        Damage{"model_outside", [](Json& j) { part_of(j)["model"]["path"] = "a/../../b"; },
               "'parts[0].model.path' is not in the folder"},
        Damage{"model_anywhere", [](Json& j) { part_of(j)["model"]["path"] = "/b.somato"; },
               "'parts[0].model.path' is not in the folder"},
        Damage{"model_seed", [](Json& j) { part_of(j)["model"]["seed"] = -1; }, "model.seed'"},
        Damage{"parts_object", [](Json& j) { j["parts"] = Json::object(); }, "'parts'"},
        Damage{"part_null", [](Json& j) { j["parts"][1] = nullptr; }, "'parts[1]' is null"},
        Damage{"samples_negative", [](Json& j) { protocol_of(j)["samples"] = -1; },
               kProtocol + "samples' is number"},
        Damage{"samples_huge", [](Json& j) { protocol_of(j)["samples"] = 1000000000000; },
               kProtocol + "runs[0].winners' has 12 entries"},
        Damage{"samples_part", [](Json& j) { protocol_of(j)["samples"] = 11.5; }, "whole number"},
        Damage{"winner_text", [](Json& j) { protocol_of(j)["runs"][1]["winners"][3] = "9"; },
               kProtocol + "runs[1].winners[3]' is string"},
        Damage{"winner_huge", [](Json& j) { protocol_of(j)["runs"][1]["winners"][3] = 1U << 30U; },
               kProtocol + "runs[1].winners[3]'"},
        Damage{"labels_short", [](Json& j) { protocol_of(j)["runs"][1]["labels"].erase(0); },
               kProtocol + "runs[1].labels' has 11 entries, but needs 12"},
        Damage{"labels_long",
               [](Json& j) { protocol_of(j)["runs"][1]["labels"].push_back("more"); },
               kProtocol + "runs[1].labels' has 13 entries, but needs 12"},
        Damage{"prediction_number",
               [](Json& j) { protocol_of(j)["runs"][0]["predictions"][0] = 4; }, "predictions[0]"},
        Damage{"values_short",
               [](Json& j) { protocol_of(j)["metrics"]["accuracy"]["values"].erase(0); },
               kProtocol + "metrics.accuracy.values' has 1 entries, but needs 2"},
        Damage{"value_text",
               [](Json& j) { protocol_of(j)["metrics"]["accuracy"]["values"][0] = "1"; },
               "accuracy.values[0]"},
        Damage{"metric_missing_mean",
               [](Json& j) { protocol_of(j)["metrics"]["accuracy"].erase("mean"); },
               "accuracy.mean' is missing"},
        Damage{"other_predictions",
               [](Json& j) { protocol_of(j)["runs"][0]["other_predictions"] = {1, 2}; },
               "other_predictions' is array"},
        Damage{"map_rows", [](Json& j) { map_of(j)["grid"]["rows"] = 0; },
               "runs[1].map.grid' is no grid"},
        Damage{"map_lattice", [](Json& j) { map_of(j)["grid"]["lattice"] = "round"; },
               "runs[1].map.grid' is no grid"},
        Damage{"map_smaller", [](Json& j) { map_of(j)["grid"]["rows"] = 1; },
               "runs[1].map.u_matrix' has 25 entries, but needs 5"},
        Damage{"map_winner", [](Json& j) { protocol_of(j)["runs"][1]["winners"][3] = 25; },
               "runs[1].map' has no neuron 25"},
        Damage{"pair_recording", [](Json& j) { part_of(j)["pairs"][0][0] = 2; },
               "'parts[0].pairs[0]' refers to a recording that does not exist"},
        Damage{"pair_short", [](Json& j) { part_of(j)["pairs"][0] = {1}; }, "has 1 entries"},
        Damage{"pairs_few", [](Json& j) { part_of(j)["pairs"].erase(0); },
               kProtocol + "runs' has 2 entries, but needs 1"},
        Damage{"recording_unknown", [](Json& j) { j["parts"][1]["recordings"][0] = 2; },
               "'parts[1].recordings[0]' refers to a recording that does not exist"},
        Damage{"test_recordings_few", [](Json& j) { j["parts"][1]["test_recordings"].erase(0); },
               "'parts[1].test_recordings' has 1 entries, but needs 2"},
        Damage{"of_each_length", [](Json& j) { chance_of(j).erase(0); }, "of_each' has 1 entries"},
        Damage{"of_each_empty", [](Json& j) { chance_of(j)[0] = Json::array(); }, "has no value"},
        Damage{"of_each_times", [](Json& j) { chance_of(j)[0][0][1] = 0.5; }, "does not state how"},
        Damage{"of_each_pair", [](Json& j) { chance_of(j)[0][0].push_back(1); }, "has 3 entries"},
        Damage{"share", [](Json& j) { j["claims"][0]["share"] = 0.5; }, "'claims[0].share'"},
        Damage{"verdict", [](Json& j) { j["claims"][0]["verdict"] = "holds"; },
               "'claims[0].verdict' is 'holds'"},
        Damage{"claim_values", [](Json& j) { j["claims"][0].erase("values"); },
               "'claims[0].values' is missing"},
        Damage{"published", [](Json& j) { j["claims"][0]["published"] = "all"; },
               "'claims[0].published' is string"},
        Damage{"no_criterion", [](Json& j) { j["claims"][2]["as_written"]["judged_by"] = "all"; },
               "'claims[2].as_written.judged_by' is no criterion"},
        Damage{"bounds_included",
               [](Json& j) { j["claims"][2]["as_written"]["bounds_included"] = 1; },
               "'claims[2].as_written.bounds_included' is number"},
        Damage{"chance_range",
               [](Json& j) { j["claims"][2]["as_written"]["chance_range"] = {1.0}; },
               "'claims[2].as_written.chance_range' has 1 entries"},
        Damage{"second_verdict", [](Json& j) { j["claims"][2]["as_written"]["verdict"] = "holds"; },
               "'claims[2].as_written.verdict' is 'holds'"},
        Damage{"not_applicable", [](Json& j) { j["not_applicable"][0].erase("reason"); },
               "'not_applicable[0].reason'"}),
    [](const auto& test) { return test.param.name; });

TEST(ResultsFile, WhatIsCutOffIsRefusedWhereverItIs) {
  const std::string whole = to_json(made_results());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 97) {
    const auto file = parse_results(std::string_view(whole).substr(0, length), "results.json");
    ASSERT_FALSE(file) << length;
    EXPECT_NE(file.error().what.find("not valid JSON"), std::string::npos) << file.error().what;
  }
}

TEST(ResultsFile, WhatIsNoJsonIsRefused) {
  for (const std::string text :
       {"", "null", "[]", "{}", "7", "\"results\"", "{\"version\": NaN}", "{\"version\": 1e400}",
        "{\"version\": 4, }", "\xFF\xFE", "<html></html>", "{\"version\": 4} {}"}) {
    const auto file = parse_results(text, "results.json");
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().kind, ErrorKind::kData);
  }
}

TEST(ResultsFile, WhatIsDeepIsNoTrouble) {
  const std::string deep =
      "{\"version\": 4, \"parts\": " + std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_FALSE(parse_results(deep, "results.json"));
  EXPECT_FALSE(parse_results(std::string(1000000, '['), "results.json"));
}

TEST(ResultsFile, ManyFieldsOfChanceAreRefusedOrRead) {
  const std::string whole = to_json(made_results());
  Random random(4);
  for (int i = 0; i < testing::fewer_if_sanitized(2000); ++i) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change) {
      text[random.below(text.size())] = "0123456789[]{}\",:-.enul"[random.below(23)];
    }
    static_cast<void>(parse_results(text, "results.json"));
  }
}

}  // namespace
}  // namespace somato

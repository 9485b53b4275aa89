#include "somato/report/results_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/made_study.h"
#include "support/study_results.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

const StudyResults& made_study() {
  static const StudyResults results =
      testing::outcome_of(testing::small_study(), testing::grasps(3, 4, 1)).results;
  return results;
}

// Two parts on two recordings, with a claim that compares them.
ReproductionResults made_reproduction() {
  ReproductionResults all;
  all.seed = 5;
  all.pairs = 2;
  all.recordings = {{"a.mcap", "lucs2, simulated", 5, "fnv1a64:0", 12},
                    {"b.mcap", "lucs2, simulated", 6, "fnv1a64:1", 12}};
  for (const std::string variation : {"", "other"}) {
    PartResults part;
    part.system = "small";
    part.variation = variation;
    part.recordings = {"a.mcap", "b.mcap"};
    part.settings = made_study().settings;
    part.protocols = made_study().systems;
    part.pairs = {{0, 5}, {1, 6}};
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
  Claim told = claim;
  told.metric = "told_exactly";
  told.than_system.clear();
  told.than_variation.clear();
  all.claims = judge({claim, told}, all.parts);
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

void expect_same(const std::vector<SystemResults>& a, const std::vector<SystemResults>& b) {
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

TEST(ResultsFile, AStudyReadsBackAsItWas) {
  const auto file = parse_results(to_json(made_study()), "results.json");
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_TRUE(file->is_study);
  ASSERT_EQ(file->parts.size(), 1U);
  const PartResults& part = file->parts.front();
  EXPECT_EQ(part.system, "small");
  EXPECT_EQ(file->find_recording(part.recordings.front())->data_hash, made_study().data_hash);
  expect_same(part.protocols, made_study().systems);
  expect_same(part.settings, made_study().settings);
  EXPECT_EQ(part.pairs.at(1).seed, 6U);
}

TEST(ResultsFile, AReproductionReadsBackAsItWas) {
  const ReproductionResults all = made_reproduction();
  const auto file = parse_results(to_json(all), "results.json");
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_FALSE(file->is_study);
  ASSERT_EQ(file->parts.size(), 2U);
  EXPECT_EQ(file->parts[1].variation, "other");
  expect_same(file->parts[1].protocols, all.parts[1].protocols);
  expect_same(file->parts[1].settings, all.parts[1].settings);
  EXPECT_EQ(file->parts[0].pairs[1].recording, 1U);
  EXPECT_EQ(file->find_recording("b.mcap")->data_hash, "fnv1a64:1");
  EXPECT_EQ(file->find_recording("c.mcap"), nullptr);
  ASSERT_FALSE(all.parts[0].protocols[0].find_metric("told_exactly_by_luck")->of_each.empty());
  ASSERT_EQ(file->claims.size(), 2U);
  EXPECT_TRUE(file->claims[1].outcome.chance_share);
  EXPECT_EQ(file->claims[1].outcome.chance_share, all.claims[1].chance_share);
  EXPECT_EQ(file->claims[1].outcome.reason(), "2 pairs; 20 are needed");
  EXPECT_EQ(file->claims[0].outcome.values, all.claims[0].values);
  EXPECT_EQ(file->claims[0].outcome.claim.published, 0.25);
  EXPECT_EQ(file->claims[0].share, all.claims[0].share());
}

// JSON has no NaN: it stands as null.
TEST(ResultsFile, AMetricThatIsNoNumberStaysNone) {
  StudyResults results = made_study();
  results.systems[0].metrics[0].values[1] = std::nan("");
  const auto file = parse_results(to_json(results), "results.json");
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_TRUE(std::isnan(file->parts[0].protocols[0].metrics[0].values[1]));
}

Json& luck_of(Json& json) {
  return json["systems"][0]["protocols"][0]["metrics"]["told_exactly_by_luck"]["of_each"];
}

struct Damage {
  std::string name;
  std::function<void(Json&)> make;
  std::string says;
};

void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.name;
}

class DamagedStudy : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedStudy, IsRefusedWithFileAndField) {
  Json json = Json::parse(to_json(made_study()));
  GetParam().make(json);
  const auto file = parse_results(json.dump(), "some/results.json");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::kData);
  EXPECT_EQ(file.error().where, "some/results.json");
  EXPECT_NE(file.error().what.find(GetParam().says), std::string::npos) << file.error().what;
}

INSTANTIATE_TEST_SUITE_P(
    By, DamagedStudy,
    ::testing::Values(
        Damage{"version", [](Json& j) { j["version"] = 2; }, "'version' is 2"},
        Damage{"version_text", [](Json& j) { j["version"] = "3"; }, "'version' is string"},
        Damage{"no_version", [](Json& j) { j.erase("version"); }, "no results.json"},
        Damage{"no_systems", [](Json& j) { j.erase("systems"); }, "no results.json"},
        Damage{"study_number", [](Json& j) { j["study"] = 7; }, "'study' is number"},
        Damage{"no_hash", [](Json& j) { j.erase("data_hash"); }, "'data_hash' is missing"},
        Damage{"settings_list", [](Json& j) { j["settings"] = Json::array(); }, "'settings'"},
        Damage{"setting_object", [](Json& j) { j["settings"]["module.map"]["rows"] = {{"a", 1}}; },
               "'settings.module.map.rows' is object"},
        Damage{"setting_huge",
               [](Json& j) { j["settings"]["module.map"]["rows"] = 18446744073709551615ULL; },
               "too large"},
        Damage{"setting_name", [](Json& j) { j["settings"]["study"]["a = 1\n[module.x]"] = 1; },
               "no name"},
        Damage{"part_name", [](Json& j) { j["settings"]["x]\n[y"]["a"] = 1; }, "no name"},
        Damage{"systems_object", [](Json& j) { j["systems"] = Json::object(); }, "'systems'"},
        Damage{"system_null", [](Json& j) { j["systems"][0] = nullptr; }, "'systems[0]' is null"},
        Damage{"samples_negative", [](Json& j) { j["systems"][0]["samples"] = -1; },
               "'systems[0].samples' is number"},
        Damage{"samples_huge", [](Json& j) { j["systems"][0]["samples"] = 1000000000000; },
               "'systems[0].runs[0].winners' has 12 entries"},
        Damage{"samples_part", [](Json& j) { j["systems"][0]["samples"] = 11.5; }, "whole number"},
        Damage{"winner_text", [](Json& j) { j["systems"][0]["runs"][1]["winners"][3] = "9"; },
               "'systems[0].runs[1].winners[3]' is string"},
        Damage{"winner_huge", [](Json& j) { j["systems"][0]["runs"][1]["winners"][3] = 1U << 30U; },
               "'systems[0].runs[1].winners[3]'"},
        Damage{"labels_short", [](Json& j) { j["systems"][0]["runs"][1]["labels"].erase(0); },
               "'systems[0].runs[1].labels' has 11 entries, where 12"},
        Damage{"labels_long",
               [](Json& j) { j["systems"][0]["runs"][1]["labels"].push_back("more"); },
               "'systems[0].runs[1].labels' has 13 entries, where 12"},
        Damage{"prediction_number",
               [](Json& j) { j["systems"][0]["runs"][0]["predictions"][0] = 4; }, "predictions[0]"},
        Damage{"values_short",
               [](Json& j) { j["systems"][0]["metrics"]["accuracy"]["values"].erase(0); },
               "'systems[0].metrics.accuracy.values' has 1 entries, where 2"},
        Damage{"value_text",
               [](Json& j) { j["systems"][0]["metrics"]["accuracy"]["values"][0] = "1"; },
               "accuracy.values[0]"},
        Damage{"metric_missing_mean",
               [](Json& j) { j["systems"][0]["metrics"]["accuracy"].erase("mean"); },
               "accuracy.mean' is missing"},
        Damage{"runs_differ",
               [](Json& j) {
                 j["systems"][1]["runs"].erase(0);
                 for (auto& metric : j["systems"][1]["metrics"]) {
                   metric["values"].erase(0);
                   if (metric.contains("of_each")) metric["of_each"].erase(0);
                 }
               },
               "'systems[1]' has another number of runs"},
        Damage{"other_predictions",
               [](Json& j) { j["systems"][0]["runs"][0]["other_predictions"] = {1, 2}; },
               "other_predictions' is array"}),
    [](const auto& test) { return test.param.name; });

class DamagedReproduction : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedReproduction, IsRefusedWithFileAndField) {
  Json json = Json::parse(to_json(made_reproduction()));
  GetParam().make(json);
  const auto file = parse_results(json.dump(), "results.json");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::kData);
  EXPECT_NE(file.error().what.find(GetParam().says), std::string::npos) << file.error().what;
}

INSTANTIATE_TEST_SUITE_P(
    By, DamagedReproduction,
    ::testing::Values(
        Damage{"version", [](Json& j) { j["version"] = 3; }, "'version' is 3"},
        Damage{"claims_missing", [](Json& j) { j.erase("claims"); }, "no results.json"},
        Damage{"pair_recording", [](Json& j) { j["systems"][0]["pairs"][0][0] = 2; },
               "'systems[0].pairs[0]' is of a recording that is not there"},
        Damage{"pair_short", [](Json& j) { j["systems"][0]["pairs"][0] = {1}; }, "has 1 entries"},
        Damage{"pairs_few", [](Json& j) { j["systems"][0]["pairs"].erase(0); },
               "'systems[0].pairs' are not as many"},
        Damage{"recording_unknown", [](Json& j) { j["systems"][1]["recordings"][0] = "c.mcap"; },
               "'systems[1].recordings' names one"},
        Damage{"of_each_length", [](Json& j) { luck_of(j).erase(0); }, "of_each' has 1 entries"},
        Damage{"of_each_empty", [](Json& j) { luck_of(j)[0] = Json::array(); }, "has no value"},
        Damage{"of_each_times", [](Json& j) { luck_of(j)[0][0][1] = 0.5; }, "does not say how"},
        Damage{"of_each_pair", [](Json& j) { luck_of(j)[0][0].push_back(1); }, "has 3 entries"},
        Damage{"share", [](Json& j) { j["claims"][0]["share"] = 1.5; }, "'claims[0].share'"},
        Damage{"published", [](Json& j) { j["claims"][0]["published"] = "all"; },
               "'claims[0].published' is string"},
        Damage{"claim_metric", [](Json& j) { j["claims"][0]["metric"] = "luck"; },
               "'claims[0]' is about something that is not in the file"}),
    [](const auto& test) { return test.param.name; });

TEST(ResultsFile, WhatIsCutOffIsRefusedWhereverItIs) {
  const std::string whole = to_json(made_study());
  for (std::size_t length = 0; length + 2 < whole.size(); length += 97) {
    const auto file = parse_results(std::string_view(whole).substr(0, length), "results.json");
    ASSERT_FALSE(file) << length;
    EXPECT_NE(file.error().what.find("not valid JSON"), std::string::npos) << file.error().what;
  }
}

TEST(ResultsFile, WhatIsNoJsonIsRefused) {
  for (const std::string text :
       {"", "null", "[]", "{}", "7", "\"results\"", "{\"version\": NaN}", "{\"version\": 1e400}",
        "{\"version\": 3, }", "\xFF\xFE", "<html></html>", "{\"version\": 3} {}"}) {
    const auto file = parse_results(text, "results.json");
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().kind, ErrorKind::kData);
  }
}

TEST(ResultsFile, WhatIsDeepIsNoTrouble) {
  const std::string deep =
      "{\"version\": 3, \"study\": \"a\", \"systems\": " + std::string(100000, '[') +
      std::string(100000, ']') + "}";
  EXPECT_FALSE(parse_results(deep, "results.json"));
  EXPECT_FALSE(parse_results(std::string(1000000, '['), "results.json"));
}

TEST(ResultsFile, ManyFieldsOfChanceAreRefusedOrRead) {
  const std::string whole = to_json(made_study());
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change) {
      text[random.below(text.size())] = "0123456789[]{}\",:-.enul"[random.below(23)];
    }
    static_cast<void>(parse_results(text, "results.json"));
  }
}

}  // namespace
}  // namespace somato

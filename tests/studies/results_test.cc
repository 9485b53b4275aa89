#include "somato/studies/results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace somato {
namespace {

using Json = nlohmann::json;

StudyResults small_results() {
  StudyResults results;
  results.study = "shapes";
  results.seeds = 2;
  results.settings = {
      {"study", {{"label", "\"object\""}, {"seeds", "2"}}},
      {"module.map", {{"radius_end", "0.5"}, {"wrap", "true"}, {"sides", "[\"a\", 3]"}}}};
  results.data_hash = "fnv1a64:00";
  results.systems = {{"shapes",
                      "leave_one_out",
                      "",
                      "object",
                      2,
                      {{"accuracy", {0.5, 1.0}}, {"areas_connected", {0.25, 0.25}}},
                      {{7, {3, 4}, {"ball", "cube"}, {"ball", "ball"}, {}},
                       {8, {3, 5}, {"ball", "cube"}, {"ball", "cube"}, {}}}}};
  return results;
}

// The document as version 3 of the format has it, written out.
const char* const kExpected = R"({
  "version": 3,
  "study": "shapes",
  "seeds": 2,
  "settings": {
    "study": {"label": "object", "seeds": 2},
    "module.map": {"radius_end": 0.5, "wrap": true, "sides": ["a", 3]}
  },
  "data_hash": "fnv1a64:00",
  "systems": [{
    "name": "shapes",
    "protocol": "leave_one_out",
    "label": "object",
    "samples": 2,
    "metrics": {
      "accuracy": {"mean": 0.75, "sd": 0.3535533905932738, "values": [0.5, 1.0]},
      "areas_connected": {"mean": 0.25, "sd": 0.0, "values": [0.25, 0.25]}
    },
    "runs": [
      {"seed": 7, "winners": [3, 4], "labels": ["ball", "cube"], "predictions": ["ball", "ball"]},
      {"seed": 8, "winners": [3, 5], "labels": ["ball", "cube"], "predictions": ["ball", "cube"]}
    ]
  }]
})";

TEST(Results, HaveTheShapeOfVersion3) {
  EXPECT_EQ(Json::parse(to_json(small_results())), Json::parse(kExpected));
}

TEST(Results, NameTheLabelOfTheGroupsAndFurtherPredictions) {
  StudyResults results = small_results();
  results.systems[0].protocol = "leave_group_out";
  results.systems[0].group = "trial";
  results.systems[0].runs[1].other_predictions = {{"shape", {"round", "flat"}},
                                                  {"colour", {"red", "red"}}};
  Json expected = Json::parse(kExpected);
  expected["systems"][0]["protocol"] = "leave_group_out";
  expected["systems"][0]["group"] = "trial";
  expected["systems"][0]["runs"][1]["other_predictions"] = {{"shape", {"round", "flat"}},
                                                            {"colour", {"red", "red"}}};
  EXPECT_EQ(Json::parse(to_json(results)), expected);
}

TEST(Results, HaveTheValuesOfEachWrongGrouping) {
  StudyResults results = small_results();
  results.systems[0].metrics[1].of_each = {{{0.0, 3}, {1.0, 1}}, {{0.25, 4}}};
  Json expected = Json::parse(kExpected);
  expected["systems"][0]["metrics"]["areas_connected"]["of_each"] =
      Json::parse("[[[0, 3], [1, 1]], [[0.25, 4]]]");
  EXPECT_EQ(Json::parse(to_json(results)), expected);
}

TEST(Results, NameTheTestDataWhereThereAreSome) {
  StudyResults results = small_results();
  results.test_data_hash = "fnv1a64:01";
  Json expected = Json::parse(kExpected);
  expected["test_data_hash"] = "fnv1a64:01";
  EXPECT_EQ(Json::parse(to_json(results)), expected);
}

TEST(Results, KeepTheOrderOfFieldsAndEndWithALine) {
  const std::string text = to_json(small_results());
  EXPECT_TRUE(text.ends_with("}\n"));
  std::size_t place = 0;
  for (const char* field : {"version", "study", "seeds", "settings", "data_hash", "systems"}) {
    const std::size_t found = text.find("\n \"" + std::string(field) + "\":");
    ASSERT_NE(found, std::string::npos) << field;
    EXPECT_GE(found, place) << field;
    place = found;
  }
}

TEST(Results, OfAStudyWithoutSystemsAreStillWhole) {
  const Json json = Json::parse(to_json(StudyResults{}));
  EXPECT_EQ(json["settings"], Json::object());
  EXPECT_EQ(json["systems"], Json::array());
}

TEST(Results, KeepEveryText) {
  StudyResults results = small_results();
  const std::vector<std::string> odd{"a\"b\\c\n\t\x01", "\xF0\x9F\x96\x90"};
  results.systems[0].runs[0].labels = odd;
  EXPECT_EQ(Json::parse(to_json(results))["systems"][0]["runs"][0]["labels"], Json(odd));
}

// JSON is UTF-8: what is not becomes the replacement character.
TEST(Results, ReplaceBytesThatAreNoText) {
  StudyResults results = small_results();
  results.systems[0].runs[0].predictions = {"b\xFFll", "cube"};
  results.settings[0].settings[0].value = "\"b\xFFll\"";
  const Json json = Json::parse(to_json(results));
  EXPECT_EQ(json["systems"][0]["runs"][0]["predictions"][0], "b\xEF\xBF\xBDll");
  EXPECT_EQ(json["settings"]["study"]["label"], "\"b\xEF\xBF\xBDll\"");
}

TEST(Results, KeepEveryBitOfAValueAndEverySeed) {
  StudyResults results = small_results();
  const double awkward = 0.1 + 0.2;
  results.systems[0].metrics[0].values = {awkward, 1.0 / 3.0};
  results.systems[0].runs[0].seed = (std::uint64_t{1} << 53) + 1;
  const Json json = Json::parse(to_json(results));
  const Json& values = json["systems"][0]["metrics"]["accuracy"]["values"];
  EXPECT_EQ(values[0].get<double>(), awkward);
  EXPECT_EQ(values[1].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["systems"][0]["runs"][0]["seed"].get<std::uint64_t>(),
            (std::uint64_t{1} << 53) + 1);
}

TEST(Metric, HasMeanAndSampleStandardDeviation) {
  // Squared differences from 5: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32, by 7.
  const Metric metric{"m", {2, 4, 4, 4, 5, 5, 7, 9}};
  EXPECT_EQ(metric.mean(), 5.0);
  EXPECT_DOUBLE_EQ(metric.standard_deviation(), std::sqrt(32.0 / 7.0));
}

// Values that have no digits left below 2: squares of them would lose the difference.
TEST(Metric, ADeviationIsNotLostBesideALargeMean) {
  Metric metric;
  metric.values = {0x1p53, 0x1p53 + 4.0};
  EXPECT_DOUBLE_EQ(metric.standard_deviation(), std::sqrt(8.0));
}

TEST(Metric, OfOneValueHasNoDeviation) {
  const Metric metric{"m", {0.3}};
  EXPECT_EQ(metric.mean(), 0.3);
  EXPECT_EQ(metric.standard_deviation(), 0.0);
  EXPECT_EQ((Metric{"m", {}}.mean()), 0.0);
}

}  // namespace
}  // namespace somato

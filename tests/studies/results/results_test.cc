#include "somato/studies/results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

namespace somato {
namespace {

using Json = nlohmann::json;

PartResults small_part() {
  PartResults part;
  part.system = "shapes";
  part.study = "[study]\nname = \"shapes\"\n";
  part.parameters = {
      {"study", {{"label", "\"object\""}, {"seeds", "2"}}},
      {"module.map", {{"radius_end", "0.5"}, {"wrap", "true"}, {"sides", "[\"a\", 3]"}}}};
  part.model = ModelFile{"system.somato", "fnv1a64:0f", 7};
  part.recordings = {{"shapes.mcap", "given", 0, "fnv1a64:00", 2}};
  part.pairs = {{0, 7}, {0, 8}};
  part.protocols = {{"leave_one_out",
                     "",
                     "object",
                     2,
                     {{"accuracy", {0.5, 1.0}}, {"areas_connected", {0.25, 0.25}}},
                     {{7, {3, 4}, {"ball", "cube"}, {"ball", "ball"}, {}},
                      {8, {3, 5}, {"ball", "cube"}, {"ball", "cube"}, {}}}}};
  return part;
}

Results small_results() {
  return {{small_part()}, {}, {}};
}

Json json_of(const PartResults& part) {
  return Json::parse(to_json(Results{{part}, {}, {}}));
}

// The document as version 4 of the format has it, written out.
const char* const kExpected = R"({
  "version": 4,
  "recordings": [{"name": "shapes.mcap", "source": "given", "seed": 0, "hash": "fnv1a64:00",
                  "explorations": 2}],
  "parts": [{
    "question": "",
    "system": "shapes",
    "variation": "",
    "study": "[study]\nname = \"shapes\"\n",
    "parameters": {
      "study": {"label": "\"object\"", "seeds": "2"},
      "module.map": {"radius_end": "0.5", "wrap": "true", "sides": "[\"a\", 3]"}
    },
    "model": {"path": "system.somato", "hash": "fnv1a64:0f", "seed": 7},
    "recordings": [0],
    "test_recordings": [],
    "pairs": [[0, 7], [0, 8]],
    "protocols": [{
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
  }],
  "claims": [],
  "not_applicable": []
})";

TEST(Results, HaveTheShapeOfVersion4) {
  EXPECT_EQ(Json::parse(to_json(small_results())), Json::parse(kExpected));
}

TEST(Results, NameTheLabelOfTheGroupsAndFurtherPredictions) {
  PartResults part = small_part();
  part.protocols[0].protocol = "leave_group_out";
  part.protocols[0].group = "trial";
  part.protocols[0].runs[1].other_predictions = {{"shape", {"round", "flat"}},
                                                 {"colour", {"red", "red"}}};
  Json expected = Json::parse(kExpected);
  Json& protocol = expected["parts"][0]["protocols"][0];
  protocol["protocol"] = "leave_group_out";
  protocol["group"] = "trial";
  protocol["runs"][1]["other_predictions"] = {{"shape", {"round", "flat"}},
                                              {"colour", {"red", "red"}}};
  EXPECT_EQ(json_of(part), expected);
}

// Distances have six significant digits.
TEST(Results, HaveTheMapThatTestedAllSamples) {
  PartResults part = small_part();
  part.protocols[0].runs[0].map =
      TrainedMap{Grid(1, 2, Lattice::kRectangular, Topology::kPlane), {1.0 / 3.0, 1234567.8}, {}};
  const auto graph = std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 1}});
  part.protocols[0].runs[1].map = TrainedMap{Grid(graph), {0.5, 0.5, 0.0}, {0.5}};
  const Json runs = json_of(part)["parts"][0]["protocols"][0]["runs"];
  EXPECT_EQ(runs[0]["map"], Json::parse(R"({"grid": {"rows": 1, "columns": 2,
      "lattice": "rectangular", "topology": "plane"}, "u_matrix": [0.333333, 1234570.0]})"));
  EXPECT_EQ(runs[1]["map"]["grid"]["edges"], Json::parse("[[0, 1]]"));
  EXPECT_EQ(runs[1]["map"]["edge_distances"], Json::parse("[0.5]"));
}

TEST(Results, HaveTheValuesOfEachWrongGrouping) {
  PartResults part = small_part();
  part.protocols[0].metrics[1].of_each = {{{0.0, 3}, {1.0, 1}}, {{0.25, 4}}};
  Json expected = Json::parse(kExpected);
  expected["parts"][0]["protocols"][0]["metrics"]["areas_connected"]["of_each"] =
      Json::parse("[[[0, 3], [1, 1]], [[0.25, 4]]]");
  EXPECT_EQ(json_of(part), expected);
}

// Two parts share one, and a test recording of the same name is another.
TEST(Results, ListEachRecordingOnce) {
  PartResults first = small_part();
  PartResults second = small_part();
  first.test_recordings = {{"shapes.mcap", "given", 0, "fnv1a64:01", 3}};
  second.recordings.push_back({"more.mcap", "lucs2", 5, "fnv1a64:02", 4});
  const Json json = Json::parse(to_json(Results{{first, second}, {}, {}}));
  ASSERT_EQ(json["recordings"].size(), 3U);
  EXPECT_EQ(json["recordings"][1]["hash"], "fnv1a64:01");
  EXPECT_EQ(json["recordings"][2]["seed"], 5);
  EXPECT_EQ(json["parts"][0]["recordings"], Json::parse("[0]"));
  EXPECT_EQ(json["parts"][0]["test_recordings"], Json::parse("[1]"));
  EXPECT_EQ(json["parts"][1]["recordings"], Json::parse("[0, 2]"));
}

TEST(Results, SayThatNoModelWasSaved) {
  PartResults part = small_part();
  part.model.reset();
  EXPECT_TRUE(json_of(part)["parts"][0]["model"].is_null());
}

TEST(Results, KeepTheOrderOfFieldsAndEndWithALine) {
  const std::string text = to_json(small_results());
  EXPECT_TRUE(text.ends_with("}\n"));
  std::size_t place = 0;
  for (const char* field : {"version", "recordings", "parts", "claims", "not_applicable"}) {
    const std::size_t found = text.find("\"" + std::string(field) + "\":", place);
    ASSERT_NE(found, std::string::npos) << field;
    place = found;
  }
}

TEST(Results, OfNothingAreStillWhole) {
  const Json json = Json::parse(to_json(Results{}));
  for (const char* list : {"recordings", "parts", "claims", "not_applicable"}) {
    EXPECT_EQ(json[list], Json::array()) << list;
  }
  const Json part = json_of(PartResults{})["parts"][0];
  EXPECT_EQ(part["parameters"], Json::object());
  EXPECT_EQ(part["protocols"], Json::array());
}

TEST(Results, KeepEveryText) {
  PartResults part = small_part();
  const std::vector<std::string> odd{"a\"b\\c\n\t\x01", "\xF0\x9F\x96\x90"};
  part.protocols[0].runs[0].labels = odd;
  part.study = odd[0];
  const Json json = json_of(part)["parts"][0];
  EXPECT_EQ(json["protocols"][0]["runs"][0]["labels"], Json(odd));
  EXPECT_EQ(json["study"], odd[0]);
}

// JSON is UTF-8: what is not becomes the replacement character.
TEST(Results, ReplaceBytesThatAreNoText) {
  PartResults part = small_part();
  part.protocols[0].runs[0].predictions = {"b\xFFll", "cube"};
  part.parameters[0].settings[0].value = "\"b\xFFll\"";
  const Json json = json_of(part)["parts"][0];
  EXPECT_EQ(json["protocols"][0]["runs"][0]["predictions"][0], "b\xEF\xBF\xBDll");
  EXPECT_EQ(json["parameters"]["study"]["label"], "\"b\xEF\xBF\xBDll\"");
}

TEST(Results, KeepEveryBitOfAValueAndEverySeed) {
  PartResults part = small_part();
  const double awkward = 0.1 + 0.2;
  const std::uint64_t seed = (std::uint64_t{1} << 53) + 1;
  part.protocols[0].metrics[0].values = {awkward, 1.0 / 3.0};
  part.protocols[0].runs[0].seed = seed;
  part.pairs[0].seed = seed;
  part.model->seed = seed;
  const Json json = json_of(part)["parts"][0];
  const Json& values = json["protocols"][0]["metrics"]["accuracy"]["values"];
  EXPECT_EQ(values[0].get<double>(), awkward);
  EXPECT_EQ(values[1].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["protocols"][0]["runs"][0]["seed"].get<std::uint64_t>(), seed);
  EXPECT_EQ(json["pairs"][0][1].get<std::uint64_t>(), seed);
  EXPECT_EQ(json["model"]["seed"].get<std::uint64_t>(), seed);
}

Claim claim(const std::string& metric, double at_least) {
  Claim made;
  made.text = "text";
  made.system = "small";
  made.metric = metric;
  made.at_least = at_least;
  return made;
}

// Mean of 10, 12, 14 and 16: 13; squared differences 9 + 1 + 1 + 9 = 20, by 3.
TEST(Results, HaveTheClaimsAndWhatTheyRestOn) {
  Claim compared = claim("accuracy", 0.5);
  compared.paper = "P11";
  compared.published = 1.25;
  compared.at_most = 3.0;
  compared.than_system = "small";
  const Json json =
      Json::parse(to_json(Results{{},
                                  {{claim("classes_separated", 11), {10, 12, 14, 16}, 52.5, 0.25},
                                   {compared, {0.25, 0.75}, {}}},
                                  {{"texture", "no channel 'sound'"}}}));
  ASSERT_EQ(json["claims"].size(), 2U);
  EXPECT_DOUBLE_EQ(json["claims"][0]["sd"], std::sqrt(20.0 / 3.0));
  Json plain = json["claims"][0];
  plain.erase("sd");
  EXPECT_EQ(plain, Json::parse(R"({"text": "text", "paper": "", "question": "", "system": "small",
      "variation": "", "metric": "classes_separated", "protocol": "train_is_test", "group": "",
      "published": null, "at_least": 11.0, "at_most": null, "share": 0.75, "mean": 13.0,
      "verdict": "cannot be decided here", "reason": "4 pairs; 20 are needed",
      "by_chance": 52.5, "chance_share": 0.25, "values": [10.0, 12.0, 14.0, 16.0]})"));
  EXPECT_FALSE(json["claims"][1].contains("as_written"));
  const Json& than = json["claims"][1];
  EXPECT_EQ(than["than_system"], "small");
  EXPECT_EQ(than["than_variation"], "");
  EXPECT_EQ(than["than_metric"], "accuracy");
  EXPECT_EQ(than["published"], 1.25);
  EXPECT_EQ(than["at_most"], 3.0);
  EXPECT_EQ(than["share"], 0.5);
  EXPECT_TRUE(than["by_chance"].is_null());
  EXPECT_TRUE(than["chance_share"].is_null());
  EXPECT_EQ(json["not_applicable"],
            Json::parse(R"([{"system": "texture", "reason": "no channel 'sound'"}])"));
}

TEST(Results, HaveTheSecondMeasureOfAClaim) {
  ClaimOutcome outcome{claim("order_around", 0.9), {0.5, 1.0}, 0.5, 0.25};
  outcome.limit = 0.875;
  outcome.claim.contradicted_by = "P11 Fig. 8";
  ClaimOutcome second{claim("exceptions_around", 0), {0, 2}, 3.5, 0.125};
  second.claim.criterion = ClaimCriterion::kCentralRange;
  second.claim.published = 1.0;
  second.recordings = {0, 1};
  second.chance_range = ClaimRange{2, 5};
  outcome.as_written = {second};
  const Json json = Json::parse(to_json(Results{{}, {outcome}, {}}))["claims"][0];
  EXPECT_EQ(json["limit"], 0.875);
  EXPECT_EQ(json["contradicted_by"], "P11 Fig. 8");
  EXPECT_EQ(json["share"], 0.5);
  Json written = json["as_written"];
  EXPECT_DOUBLE_EQ(written["sd"], std::sqrt(2.0));
  written.erase("sd");
  EXPECT_EQ(written, Json::parse(R"({"judged_by": "central_range", "metric": "exceptions_around",
      "published": 1.0, "at_least": 0.0, "at_most": null, "bounds_included": true,
      "verdict": "cannot be decided here", "reason": "2 pairs; 20 are needed", "share": 1.0,
      "mean": 1.0, "by_chance": 3.5, "chance_share": 0.125, "values": [0.0, 2.0], "range": [0.0, 2.0],
      "chance_range": [2.0, 5.0], "recordings": [0, 1]})"));
}

// Pairs of 1, 1, 1 and 5, the last one with another recording.
TEST(Results, HaveTheMeanOfTheRecordingsOfATendency) {
  ClaimOutcome outcome{claim("order_around", 0.9), {1, 1, 1, 5}, {}};
  ClaimOutcome second{claim("order_around", 0), {1, 1, 1, 5}, {}};
  second.claim.criterion = ClaimCriterion::kMean;
  second.claim.bounds_included = false;
  second.recordings = {0, 0, 0, 1};
  outcome.as_written = {second};
  const Json json = Json::parse(to_json(Results{{}, {outcome}, {}}))["claims"][0];
  EXPECT_EQ(json["mean"], 2.0);
  EXPECT_EQ(json["as_written"]["mean"], 3.0);
  EXPECT_EQ(json["as_written"]["bounds_included"], false);
}

TEST(Results, HaveNoMeanOfAMetricThatWasNotMeasured) {
  ClaimOutcome outcome{claim("order_around", 0.9), {0.5, 1.0}, {}};
  ClaimOutcome second{claim("exceptions_around", 0), {}, {}};
  second.undecidable = "not measured";
  outcome.as_written = {second};
  const Json written = Json::parse(to_json(Results{{}, {outcome}, {}}))["claims"][0]["as_written"];
  EXPECT_EQ(written["reason"], "not measured");
  for (const char* key : {"mean", "sd", "range", "chance_range"}) {
    EXPECT_TRUE(written[key].is_null()) << key;
  }
  EXPECT_EQ(written["values"], Json::array());
}

TEST(Settings, AreATableOfToml) {
  EXPECT_EQ(to_toml(Settings{"explore.plan", {{"noise", "0.5"}, {"body", "\"lucs2\""}}}),
            "\n[explore.plan]\nnoise = 0.5\nbody = \"lucs2\"\n");
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

#include "views/report/inference_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/support/json_schema.h"
#include "views/report/report.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

// As 'somato sweep --targets' writes it, with one entry of each list.
constexpr std::string_view kInferenceText = R"({
"version": 1, "systems": ["press"], "draws": 8, "pairs": 2, "accepted": 3, "adjusted": false,
"inference": {"accepted": 0.2, "adjusted": true, "truths": 1, "bodies": 4, "pairs": 5, "seed": 1},
"targets": [{"text": "Three", "paper": "", "system": "press", "variation": "", "metric": "m",
  "protocol": "train_is_test", "observed": 3, "scale": 1, "prior": 4.5, "posterior": 3.25}],
"unknowns": [{"name": "rate", "key": ["module.map.rate"], "text": "Open.", "system": "0.3",
  "cells": [{"from": 0.1, "to": 0.5, "prior": 0.5, "posterior": 0.25},
            {"from": "each", "to": "each", "prior": 0.5, "posterior": 0.75}],
  "prior": {"low": 0.1, "median": true, "high": "each"},
  "posterior": {"low": 0.1, "median": 0.3, "high": 0.5}, "shrinkage": 0.75}],
"dependences": [{"first": "rate", "second": "rate", "correlation": -0.5}],
"calibration": {"truths": 1, "unknowns": [
  {"name": "rate", "covered": 1, "uniform_p": 0.5, "ranks": [0.5]}]},
"claims": [{"text": "It holds", "paper": "P11", "question": "", "system": "press", "variation": "",
  "metric": "m", "protocol": "train_is_test", "group": "", "published": null, "at_least": 1,
  "at_most": null, "prior": 0.5, "posterior": 1, "left_out": null, "fresh": 0.25,
  "fresh_verdict": "fails", "fresh_verdict_as_written": null, "chance": 0.125,
  "fresh_chance": null, "draws": 8, "support": "reachable"}],
"conflicts": [{"first": {"system": "press", "variation": "", "text": "A"},
  "second": {"system": "press", "variation": "small", "text": "B"},
  "together": 1, "expected": 6.5, "deviations": -3.5}],
"joint": {"claims": 1,
  "prior": {"bodies": 1, "mean": 0.5, "sums": [0.5], "not_failing": 1,
            "not_failing_as_written": 0},
  "fresh": {"bodies": 1, "mean": 1, "sums": [1], "not_failing": 1, "not_failing_as_written": 1}},
"bodies": []})";

Json inference_text() {
  return Json::parse(kInferenceText);
}

Result<Json> parsed(const Json& json) {
  return detail::parse_inference(json.dump(), "i.json");
}

std::string refusal_of(const Json& json) {
  const auto read = parsed(json);
  EXPECT_FALSE(read);
  return read ? std::string() : read.error().what + " in " + read.error().where;
}

TEST(InferenceFile, IsPartOfAReportThatFitsItsSchema) {
  const auto report = make_report({}, {}, {{"i.json", std::string(kInferenceText)}});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->inferences, 1U);
  EXPECT_TRUE(testing::text_fits_schema(report->json, "report.json"));
  const Json inference = Json::parse(report->json)["inferences"][0];
  EXPECT_EQ(inference["file"], "i.json");
  EXPECT_EQ(inference["bodies"], 4);
  EXPECT_EQ(inference["fresh_pairs"], 5);
  EXPECT_EQ(inference["targets"][0]["posterior"], 3.25);
  EXPECT_EQ(inference["unknowns"][0]["cells"][1]["from"], "each");
  EXPECT_EQ(inference["unknowns"][0]["prior"]["median"], true);
  EXPECT_EQ(inference["calibration"][0]["ranks"], Json::array({0.5}));
  EXPECT_TRUE(inference["claims"][0]["left_out"].is_null());
  EXPECT_EQ(inference["claims"][0]["than"], "");
  EXPECT_EQ(inference["conflicts"][0]["second"]["variation"], "small");
  EXPECT_EQ(inference["joint"]["fresh"]["not_failing_as_written"], 1);
  EXPECT_FALSE(Json::parse(make_report({}, {})->json).contains("inferences"));
}

TEST(InferenceFile, AComparisonNamesTheOtherSystem) {
  Json json = inference_text();
  json["claims"][0]["than_system"] = "chain";
  json["claims"][0]["than_variation"] = "small";
  const Json claim = parsed(json).value()["claims"][0];
  EXPECT_EQ(claim["than"], "chain, small");
  EXPECT_EQ(claim["than_metric"], "m") << "of the claim itself";
}

TEST(InferenceFile, EveryFieldThatIsShownMustBeThere) {
  EXPECT_TRUE(parsed(inference_text()));
  const Json whole = inference_text().flatten();
  for (const auto& [pointer, value] : whole.items()) {
    // Neither shown nor of the report: the rule, the posterior on its own seeds, and others.
    Json json = inference_text();
    json[nlohmann::ordered_json::json_pointer(pointer)] = Json::object({{"wrong", 1}});
    const bool is_unused = pointer == "/inference/accepted" || pointer == "/inference/adjusted" ||
                           pointer == "/inference/truths" || pointer == "/inference/seed" ||
                           pointer == "/claims/0/question" || pointer == "/claims/0/group" ||
                           pointer == "/claims/0/posterior" || pointer == "/claims/0/draws" ||
                           pointer == "/joint/claims" || pointer == "/joint/prior/bodies" ||
                           pointer == "/joint/fresh/bodies" || pointer == "/bodies";
    EXPECT_EQ(parsed(json).has_value(), is_unused) << pointer;
  }
}

TEST(InferenceFile, WrongValuesAreNamed) {
  Json json = inference_text();
  json["claims"][0].erase("fresh_chance");
  EXPECT_EQ(refusal_of(json), "'claims[0].fresh_chance' is missing in i.json");
  json = inference_text();
  json["claims"][0]["prior"] = 1.5;
  EXPECT_EQ(refusal_of(json), "'claims[0].prior' is not a share from 0 to 1 in i.json");
  json = inference_text();
  json["claims"][0]["support"] = "proved";
  EXPECT_EQ(refusal_of(json), "'claims[0].support' is no support of a claim in i.json");
  json = inference_text();
  json["unknowns"][0]["cells"] = Json::array();
  EXPECT_EQ(refusal_of(json), "'unknowns[0].cells' has no part of the range in i.json");
  json = inference_text();
  json["version"] = 2;
  EXPECT_EQ(refusal_of(json),
            "written by a newer version of Somato (format 2, supported is 1) in i.json");
  EXPECT_FALSE(detail::parse_inference("{", "i.json"));
  EXPECT_FALSE(detail::parse_inference("[]", "i.json"));
  EXPECT_FALSE(detail::parse_inference("null", "i.json"));
}

}  // namespace
}  // namespace somato

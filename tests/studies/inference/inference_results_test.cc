#include "studies/inference/inference_results.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies/inference/inferences.h"

namespace somato {
namespace {

using Json = nlohmann::json;

TEST(InferenceResults, AreWrittenAsJson) {
  const Targets targets = test::targets_of("[inference]\naccepted = 0.1\n" + test::kTarget).value();
  const SweepResults results = test::rates_as_accuracies(64, targets);
  const Inference found = infer(results, targets).value();
  SweepResults fresh{results.sweep, {results.points[0], results.points[1]}};
  const Json json = Json::parse(to_json(with_claims(results, targets, found, fresh)));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["systems"], Json::array({"press"}));
  EXPECT_EQ(json["draws"], 64);
  EXPECT_EQ(json["accepted"], found.posterior.size());
  EXPECT_EQ(json["targets"][0]["observed"], 0.5);
  EXPECT_NEAR(json["targets"][0]["prior"].get<double>(), 0.5, 0.03);
  const Json rate = json["unknowns"][0];
  EXPECT_EQ(rate["name"], "rate");
  EXPECT_EQ(rate["system"], "0.3");
  EXPECT_NEAR(rate["posterior"]["median"].get<double>(), 0.5, 0.05);
  EXPECT_NEAR(rate["prior"]["low"].get<double>(), 0.14, 0.02);
  EXPECT_EQ(rate["cells"].size(), 8U);
  EXPECT_EQ(json["unknowns"][1]["posterior"]["median"].is_string(), true);
  EXPECT_EQ(json["dependences"].size(), 1U);
  EXPECT_EQ(json["calibration"]["unknowns"][0]["ranks"].size(), 20U);
  EXPECT_EQ(json["claims"][0]["support"], "reachable");
  EXPECT_TRUE(json["claims"][0]["left_out"].is_null());
  EXPECT_NEAR(json["claims"][0]["values"]["greatest"].get<double>(), 0.9, 0.05);
  EXPECT_EQ(json["joint"]["fresh"]["bodies"], 2);
  EXPECT_EQ(json["joint"]["claims"], 2);
  EXPECT_EQ(json["joint"]["fresh"]["sums"].size(), 2U);
  EXPECT_EQ(json["joint"]["fresh"]["not_failing"], 0U) << "4 pairs decide nothing";
  EXPECT_EQ(json["claims"][0]["fresh_verdict"], "cannot be decided here");
  EXPECT_EQ(json["claims"][0]["fresh_verdict_as_written"], "cannot be decided here");
  EXPECT_TRUE(json["claims"][0]["fresh_chance"].is_null());
  EXPECT_EQ(json["bodies"].size(), 2U);
  EXPECT_EQ(json["bodies"][0]["rate"], 0.1);
}

}  // namespace
}  // namespace somato

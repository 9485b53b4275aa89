#include "studies/sweep/sweep_results.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies/sweep/sweeps.h"

namespace somato {
namespace {

using Json = nlohmann::json;
using test::kDraws;
using test::planned;
using test::sweep_toml;

const std::string kRows =
    "[unknown.rows]\nkey = 'module.map.rows'\ntext = 'x'\nvalues = [3, 5, 9]\n";

PartResults found(const std::string& variation, const std::vector<double>& accuracy) {
  PartResults part;
  part.system = "press";
  part.variation = variation;
  part.recordings = {{"one.mcap", "", 5, "", 0}};
  part.protocols.push_back({"train_is_test", {}, "material", 8, {}, {}});
  part.protocols[0].metrics.push_back({"accuracy", accuracy});
  return part;
}

// The first claim holds in `holding` of four pairs at each point, the second one everywhere.
SweepResults results(const std::string& design, const std::vector<int>& holding) {
  SweepResults results{planned(sweep_toml(design, kRows + kDraws)).value(), {}};
  const auto points = sweep_points(results.sweep.sweep);
  EXPECT_EQ(points.size(), holding.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> accuracy(4, 0.25);
    for (int pair = 0; pair < holding[i]; ++pair) accuracy[static_cast<std::size_t>(pair)] = 0.75;
    const std::vector<PartResults> parts{found("", accuracy), found("small", {0, 0, 0, 0})};
    results.points.push_back(judge_point(results.sweep, points[i], parts));
  }
  return results;
}

TEST(SweepResults, CountThePointsAtWhichAClaimHolds) {
  // rows 3, 5, 9 times two orders of drawing
  const SweepResults all = results("full_factorial", {0, 0, 4, 4, 4, 2});
  const ClaimEffects over = effects_on(all, 0);
  EXPECT_EQ(over.points, 6U);
  EXPECT_DOUBLE_EQ(over.holds, 0.5);
  EXPECT_DOUBLE_EQ(over.mean_share, 3.5 / 6);
  EXPECT_FALSE(over.system_share);
  const UnknownEffect& rows = over.effects[0];
  ASSERT_EQ(rows.cells.size(), 3U);
  EXPECT_EQ(rows.cells[0].points, 2U);
  EXPECT_DOUBLE_EQ(rows.cells[0].share, 0.0);
  EXPECT_DOUBLE_EQ(rows.cells[1].share, 1.0);
  EXPECT_DOUBLE_EQ(rows.cells[2].share, 0.75);
  EXPECT_DOUBLE_EQ(rows.change, 1.0);
  // Variance 6/6 of cells around 3.5/6, and the rest within the last cell: 2 * 0.25^2.
  const double total =
      2 * (3.5 / 6) * (3.5 / 6) + 3 * (2.5 / 6) * (2.5 / 6) + (0.5 / 6) * (0.5 / 6);
  EXPECT_NEAR(rows.order->index, 1.0 - 2 * 0.25 * 0.25 / total, 1e-12);
  EXPECT_DOUBLE_EQ(rows.order->by_chance, 0.4);
  EXPECT_EQ(over.by_effect(), (std::vector<std::size_t>{0, 1}));
  const ClaimEffects second = effects_on(all, 1);
  EXPECT_DOUBLE_EQ(second.holds, 1.0);
  EXPECT_FALSE(second.effects[0].order);
}

TEST(SweepResults, OneAtATimeShowsHowFarEachUnknownChangesTheShare) {
  // The system, three rows, two orders.
  const ClaimEffects over = effects_on(results("one_at_a_time", {3, 0, 3, 4, 3, 2}), 0);
  EXPECT_DOUBLE_EQ(*over.system_share, 0.75);
  EXPECT_DOUBLE_EQ(over.effects[0].change, 1.0);
  EXPECT_DOUBLE_EQ(over.effects[1].change, 0.25);
  EXPECT_EQ(over.effects[1].cells[0].points, 1U);
  EXPECT_FALSE(over.effects[0].order);
  EXPECT_EQ(over.by_effect(), (std::vector<std::size_t>{0, 1}));
}

// In 19 of 20 pairs it holds, in 18 it does not.
TEST(SweepResults, AClaimHoldsFromNineteenOfTwentyPairsOn) {
  SweepResults all{planned(sweep_toml("one_at_a_time", kDraws)).value(), {}};
  const auto points = sweep_points(all.sweep.sweep);
  for (const std::size_t holding : {20U, 19U, 18U}) {
    std::vector<double> accuracy(20, 0.0);
    for (std::size_t i = 0; i < holding; ++i) accuracy[i] = 1.0;
    all.points.push_back(judge_point(all.sweep, points[all.points.size()], {found("", accuracy)}));
  }
  EXPECT_DOUBLE_EQ(effects_on(all, 0).holds, 2.0 / 3.0);
  EXPECT_EQ(effects_on(all, 1).points, 0U);  // the variation was not run
}

TEST(SweepResults, AreWrittenAsJson) {
  const SweepResults all = results("one_at_a_time", {3, 0, 3, 4, 3, 2});
  const std::string text = to_json(all);
  EXPECT_EQ(text, to_json(results("one_at_a_time", {3, 0, 3, 4, 3, 2})));
  const Json json = Json::parse(text);
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["system"], "press");
  EXPECT_EQ(json["design"], "one_at_a_time");
  EXPECT_EQ(json["unknowns"][0]["system"], "5");
  EXPECT_EQ(json["unknowns"][0]["cells"][2]["from"], 9);
  EXPECT_EQ(json["unknowns"][1]["cells"][0]["to"], "with_replacement");
  const Json& claim = json["claims"][0];
  EXPECT_EQ(claim["text"], "All materials are named.");
  EXPECT_EQ(claim["points"], 6);
  EXPECT_DOUBLE_EQ(claim["holds"], 1.0 / 6);
  EXPECT_EQ(claim["unknowns"][0]["change"], 1.0);
  EXPECT_TRUE(claim["unknowns"][0]["first_order"].is_null());
  ASSERT_EQ(json["points"].size(), 6U);
  EXPECT_TRUE(json["points"][0]["values"]["rows"].is_null());
  EXPECT_EQ(json["points"][3]["values"]["rows"], 9);
  EXPECT_EQ(json["points"][3]["recordings"], Json::parse("[\"one.mcap\"]"));
  EXPECT_EQ(json["points"][3]["claims"][0]["share"], 1.0);
  EXPECT_EQ(json["points"][5]["claims"][0]["values"], Json::parse("[0.75, 0.75, 0.25, 0.25]"));
}

}  // namespace
}  // namespace somato

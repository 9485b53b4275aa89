#include "views/curves/curves.h"

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "base/support/json_schema.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

// The curves, each checked by its schema.
Json curves_json(const std::vector<const PartResults*>& parts,
                 const std::vector<const ClaimOutcome*>& claims,
                 const std::map<std::string, std::string>& units) {
  Json curves = detail::curves_json(parts, claims, units);
  EXPECT_TRUE(testing::fits_schema(curves, "report.json#/$defs/ReportData/properties/curves"));
  return curves;
}

// Parts of one question, with a metric a protocol.
class Curves : public ::testing::Test {
 protected:
  void add(const std::string& system, const std::string& variation, std::vector<Settings> settings,
           std::vector<double> accuracy) {
    PartResults part;
    part.question = "placement";
    part.system = system;
    part.variation = variation;
    part.parameters = std::move(settings);
    ProtocolResults protocol;
    protocol.protocol = "leave_group_out";
    protocol.group = "trial";
    protocol.metrics = {{"accuracy", accuracy}, {"neighbours_same_class", {7, 9}}};
    part.protocols = {protocol};
    results_.push_back(std::move(part));
    parts_.push_back(&results_.back());
  }

  static std::vector<Settings> noise(const std::string& value, const std::string& seed = "1") {
    return {{"study", {{"first_seed", seed}, {"label", "\"object\""}}},
            {"explore.simulation", {{"placement_noise", value}}}};
  }

  std::deque<PartResults> results_;
  std::vector<const PartResults*> parts_;
};

TEST_F(Curves, PartsThatDifferInOneNumberAreALine) {
  add("product", "careless", noise("2.0"), {0.5, 0.7});
  add("product", "", noise("0.0"), {0.9, 1.0});
  add("product", "very_careless", noise("4.0", "6"), {0.3, 0.3});
  add("chain", "", noise("2.0"), {0.8, 0.8});
  add("chain", "exact", noise("0.0"), {1.0, 1.0});
  const Json curves = curves_json(parts_, {}, {{"explore.simulation.placement_noise", "mm"}});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0]["x"], "placement_noise");
  EXPECT_EQ(curves[0]["unit"], "mm");
  EXPECT_EQ(curves[0]["metric"], "accuracy");
  EXPECT_EQ(curves[0]["title"],
            "accuracy by placement_noise of explore.simulation (leave_group_out, trial)");
  const Json& lines = curves[0]["lines"];
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["name"], "product");
  EXPECT_EQ(lines[0]["points"][1]["x"], 2.0);
  EXPECT_EQ(lines[0]["points"][1]["mean"], 0.6);
  EXPECT_EQ(lines[0]["points"][1]["values"], Json::array({0.5, 0.7}));
  EXPECT_EQ(lines[1]["name"], "chain");
  EXPECT_EQ(lines[1]["points"].size(), 2U);
}

TEST_F(Curves, WhatIsClaimedHasACurveToo) {
  for (const std::string value : {"0.0", "1.0", "2.0"}) add("a", value, noise(value), {0, 1});
  ClaimOutcome judged;
  judged.claim.question = "placement";
  judged.claim.system = "a";
  judged.claim.metric = "neighbours_same_class";
  judged.claim.protocol = "leave_group_out";
  judged.claim.group = "trial";
  ASSERT_EQ(curves_json(parts_, {&judged, &judged}, {}).size(), 2U);
  EXPECT_EQ(curves_json(parts_, {&judged}, {})[1]["metric"], "neighbours_same_class");
  judged.claim.question = "another";
  EXPECT_EQ(curves_json(parts_, {&judged}, {}).size(), 1U);
}

TEST_F(Curves, OneNumberOfSeveralModulesIsOne) {
  for (const std::string value : {"0.5", "1.0", "2.0"}) {
    add("a", value == "1.0" ? "" : value,
        {{"module.x", {{"type", "\"t_mpsom\""}, {"arbor_sigma", value}}},
         {"module.y", {{"arbor_sigma", value}}}},
        {1, 1});
  }
  const Json curves = curves_json(parts_, {}, {});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0]["unit"], "neurons");
  EXPECT_EQ(curves[0]["lines"][0]["points"][0]["x"], 0.5);
}

TEST_F(Curves, SchedulesThatFollowTheLengthOfTrainingAreNoOtherChange) {
  const auto settings = [](const std::string& iterations, const std::string& reached) {
    return std::vector<Settings>{
        {"module.map", {{"iterations", iterations}, {"radius_reached_at", reached}}}};
  };
  add("a", "", settings("100", "100"), {1, 1});
  add("a", "longer", settings("200", "200"), {1, 1});
  add("a", "longest", settings("300", "300"), {1, 1});
  ASSERT_EQ(curves_json(parts_, {}, {}).size(), 1U);
  EXPECT_EQ(curves_json(parts_, {}, {})[0]["x"], "iterations");
  parts_.pop_back();
  add("a", "longest", settings("300", "250"), {1, 1});
  EXPECT_EQ(curves_json(parts_, {}, {}), Json::array());
}

TEST_F(Curves, TwoPointsOrMixedChangesAreNone) {
  add("a", "", noise("0.0"), {1, 1});
  add("a", "other", noise("1.0"), {1, 1});
  EXPECT_EQ(curves_json(parts_, {}, {}), Json::array());
  auto both = noise("2.0");
  both[0].settings[1].value = "\"shape\"";
  add("a", "both", both, {1, 1});
  add("a", "text", noise("\"much\""), {1, 1});
  auto more = noise("3.0");
  more.push_back({"explore", {{"body", "\"lucs2\""}}});
  add("a", "more", more, {1, 1});
  EXPECT_EQ(curves_json(parts_, {}, {}), Json::array());
  EXPECT_EQ(curves_json({}, {}, {}), Json::array());
}

}  // namespace
}  // namespace somato

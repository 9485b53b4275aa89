// Reports of the papers' nine systems, each run once on made-up touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "views/report/report.h"
#include "views/support/made_report.h"
#include "views/support/unpacked_json.h"

namespace somato {
namespace {

using testing::Json;
using testing::MadeStudy;
using testing::report_of;

Channel made(const std::string& name, std::size_t elements, std::size_t frames, double low,
             double high, Random& random) {
  Matrix<float> values(frames, elements);
  for (float& value : values.values()) {
    value = static_cast<float>(low + (high - low) * random.uniform());
  }
  return {name, "", {}, std::move(values), {}, name == "sound" ? 44100.0 : 0.0, {elements}, {}};
}

// All that any of the nine listens to, within the ranges of their codes.
Recording made_touch(std::size_t joints) {
  Random random(3);
  Recording recording;
  for (std::size_t thing = 0; thing < 4; ++thing) {
    for (std::size_t trial = 0; trial < 2; ++trial) {
      const std::string number = std::to_string(thing);
      recording.explorations.push_back(
          {{{"object", thing == 0 ? "boule" : "thing " + number},
            {"shape", thing < 2 ? "sphere" : "block"},
            {"symmetry", thing < 2 ? "radial" : "none"},
            {"width", std::to_string(40 + 10 * thing)},
            {"material", thing == 0 ? "metal" : "stuff " + number},
            {"hardness", thing < 2 ? "hard" : "soft"},
            {"trial", std::to_string(trial + 1)}},
           "",
           {made("height", 1, 6, 101, 249, random), made("wrist", 1, 6, -89, 89, random),
            made("joints", joints, 6, 1, 29, random), made("touch_change", 45, 6, 0, 1, random),
            made("sound", 1, 8192, -1, 1, random),
            made("potentiometer", 1, 6, 1, 262143, random)}});
    }
  }
  return recording;
}

class OfNineSystems : public ::testing::TestWithParam<std::size_t> {
 protected:
  static ReportThing boule() {
    return {"boule", "sphere", std::array<double, 3>{82, 82, 82}, 0.0, "metal", "hard", {}, 2.2};
  }
};

std::vector<Claim> claims_of(const NamedFile& file) {
  ReproductionPlan plan;
  static_cast<void>(add_to_plan(file, {}, plan));
  return plan.claims;
}

StudyDescription once(const NamedFile& file, const std::vector<NamedFile>& systems) {
  ReproductionPlan plan;
  static_cast<void>(add_to_plan(file, systems, plan));
  StudyDescription description = plan.parts.front().description;
  description.study.seeds = 1;
  description.study.wrong_groupings = 2;
  description.study.protocols = {Protocol::kTrainIsTest};
  description.study.groups = {};
  description.text.clear();
  return description;
}

TEST_P(OfNineSystems, HoldsWhatTheResultsSay) {
  const OwnSystems own = own_systems().value();
  const NamedFile& file = own.systems.at(GetParam());
  const MadeStudy study(once(file, own.systems),
                        made_touch(file.name == "shape_and_size" ? 11 : 6));
  ReportSources sources = study.sources();
  sources.things = {boule()};
  const Json report = report_of({study.file()}, sources);
  const Json results = Json::parse(to_json(study.file().results));
  const Json& system = report["systems"][0];
  EXPECT_EQ(system["missing"], Json::array());
  Json metrics = results["parts"][0]["protocols"][0]["metrics"];
  for (Json& metric : metrics) metric.erase("of_each");
  EXPECT_EQ(system["protocols"][0]["metrics"], metrics);
  EXPECT_EQ(system["graph"]["modules"].size(), study.description.system.modules.size());
  EXPECT_EQ(system["grid"]["rows"], 15);
  EXPECT_EQ(system["trained"]["seed"], 1);
  const auto hits = system["trained"]["hits"].get<std::vector<int>>();
  EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), 0), 8);
  EXPECT_FALSE(system["trained"]["planes"].empty());
  for (const Json& planes : system["trained"]["planes"]) {
    const std::size_t elements = planes["channel"]["elements"].size();
    EXPECT_EQ(planes["values"]["columns"], elements);
    EXPECT_EQ(testing::unpacked(planes["values"]).size(), 225U * elements);
    EXPECT_LE(planes["channel"]["elements"].size(), 256U);
  }
  EXPECT_EQ(system["things"].size(), 4U);
  EXPECT_EQ(system["things"][0]["size"], Json::array({82.0, 82.0, 82.0}));
  EXPECT_EQ(system["moments"].size(), 8U);
  EXPECT_FALSE(system["not_given"].empty());
}

TEST_P(OfNineSystems, HasTheClaimsOfTheResults) {
  const OwnSystems own = own_systems().value();
  const NamedFile& file = own.systems.at(GetParam());
  const MadeStudy study(once(file, own.systems),
                        made_touch(file.name == "shape_and_size" ? 11 : 6));
  const Json report = report_of({study.file(claims_of(file))}, study.sources());
  const auto judged = judge(claims_of(file), {study.outcome.results});
  ASSERT_EQ(report["claims"].size(), judged.size());
  EXPECT_GT(judged.size(), 0U);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    EXPECT_EQ(report["claims"][i]["text"], judged[i].claim.text);
    EXPECT_EQ(report["claims"][i]["values"], Json(judged[i].values));
    EXPECT_EQ(report["claims"][i]["share"], judged[i].share());
    EXPECT_EQ(report["claims"][i]["verdict"], choice_name(judged[i].verdict()));
    EXPECT_EQ(report["claims"][i]["reason"], judged[i].reason());
    EXPECT_EQ(report["claims"][i]["system"], file.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, OfNineSystems, ::testing::Range<std::size_t>(0, 9));

TEST(ReportOfSystems, FoldsTheTensorChainBackToTheHand) {
  const OwnSystems own = own_systems().value();
  const auto file = std::find_if(own.systems.begin(), own.systems.end(),
                                 [](const NamedFile& one) { return one.name == "tensor_chain"; });
  const MadeStudy study(once(*file, own.systems), made_touch(6));
  const Json planes = report_of({study.file()}, study.sources())["systems"][0]["trained"]["planes"];
  ASSERT_EQ(planes.size(), 4U);
  const Som& som = study.outcome.map();
  ASSERT_EQ(som.input_size(), 270000U);
  for (const std::size_t neuron : {0U, 112U, 224U}) {
    std::vector<double> touch(45);
    double wrist = 0.0;
    double all = 0.0;
    for (std::size_t e = 0; e < som.input_size(); ++e) {
      const double weight = double{som.weight(neuron, e)};
      touch[e % 45] += weight;
      wrist += weight * (-81.0 + 18.0 * static_cast<double>(e / (60 * 45) % 10));
      all += weight;
    }
    for (std::size_t t = 0; t < 45; ++t) {
      EXPECT_NEAR(testing::unpacked_row(planes[3]["values"], neuron)[t], touch[t], 1e-5 * all);
    }
    // The range of the wrist is 180 degrees at most, in 65534 steps.
    EXPECT_NEAR(testing::unpacked_row(planes[1]["values"], neuron)[0], wrist / all, 3e-3);
  }
}

Json claim_about(const Json& report, const std::string& metric) {
  for (const Json& claim : report["claims"]) {
    if (claim["metric"] == metric) return claim;
  }
  return nullptr;
}

TEST(ReportOfSystems, ClaimsThatTheExplorationsCannotDecideHaveAReason) {
  const OwnSystems own = own_systems().value();
  const auto file = std::find_if(own.systems.begin(), own.systems.end(), [](const NamedFile& one) {
    return one.name == "t_mpsom_multiplied";
  });
  const MadeStudy study(once(*file, own.systems), made_touch(6));
  const Json report = report_of({study.file(claims_of(*file))}, study.sources());
  EXPECT_EQ(report["systems"][0]["missing"], Json::array());
  const Json neighbours_same_class = claim_about(report, "neighbours_same_class");
  EXPECT_EQ(neighbours_same_class["verdict"], "cannot be decided here");
  EXPECT_EQ(neighbours_same_class["reason"], "8 explorations; 28 are needed");
  EXPECT_EQ(claim_about(report, "mapped_with boccia boule")["reason"],
            "no exploration of 'boccia'");
  EXPECT_EQ(claim_about(report, "shape.areas_connected")["reason"], "1 pair; 20 are needed");
}

TEST(ReportOfSystems, AClaimAboutTwoThingsIsJudgedWhereBothAreThere) {
  const OwnSystems own = own_systems().value();
  const auto file = std::find_if(own.systems.begin(), own.systems.end(), [](const NamedFile& one) {
    return one.name == "t_mpsom_multiplied";
  });
  Recording recording = made_touch(6);
  for (Exploration& exploration : recording.explorations) {
    if (exploration.labels[0].value == "thing 1") exploration.labels[0].value = "boccia";
  }
  const MadeStudy study(once(*file, own.systems), recording);
  const Json report = report_of({study.file(claims_of(*file))}, study.sources());
  EXPECT_EQ(claim_about(report, "mapped_with boccia boule")["reason"], "1 pair; 20 are needed");
}

// The name is that of one of the nine, and its results make no claim.
TEST(ReportOfSystems, WhatIsNotInTheResultsIsNotClaimed) {
  const OwnSystems own = own_systems().value();
  const auto file = std::find_if(own.systems.begin(), own.systems.end(),
                                 [](const NamedFile& one) { return one.name == "hardness"; });
  StudyDescription description = once(*file, own.systems);
  for (ModuleDescription& module : description.system.modules) {
    for (Table::Entry& entry : module.settings.entries) {
      if (entry.name == "rows") entry.content = Value{std::int64_t{14}};
    }
  }
  const MadeStudy study(description, made_touch(6));
  const Json report = report_of({study.file()}, study.sources());
  EXPECT_EQ(report["claims"], Json::array());
  EXPECT_EQ(report["systems"][0]["grid"]["rows"], 14);
}

}  // namespace
}  // namespace somato

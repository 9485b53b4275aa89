#include "views/report/samples_json.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/support/json_schema.h"
#include "bodies/objects/exploration_source.h"
#include "views/report/three_explorations.h"

namespace somato {
namespace {

using detail::Evidence;
using Json = nlohmann::ordered_json;

// A part of a system of the report, checked by its schema.
Json checked(Json part, const std::string& name) {
  EXPECT_TRUE(testing::fits_schema(part, "report.json#/$defs/SystemReport/properties/" + name));
  return part;
}
Json samples_of(const Evidence& evidence) {
  return checked(detail::samples_json(evidence), "samples");
}
Json things_of(const Evidence& evidence, const ReportSources& known) {
  return checked(detail::things_json(evidence, known), "things");
}
ReportSources knowing(std::vector<ReportThing> things, std::vector<ReportThing> built_in = {}) {
  ReportSources sources;
  sources.things = std::move(things);
  sources.built_in_things = std::move(built_in);
  return sources;
}

class SamplesJson : public testing::ThreeExplorations {};

TEST_F(SamplesJson, LabelsStandInTheOrderOfTheSamples) {
  evidence_.explorations = {2, 0};
  EXPECT_EQ(samples_of(evidence_)[0]["object"], "cube");
  EXPECT_EQ(samples_of(evidence_)[1]["material"], "wood");
  evidence_.recording = nullptr;
  EXPECT_TRUE(samples_of(evidence_).is_null());
}

TEST_F(SamplesJson, AThingThatIsKnownIsCompletedUnlessItContradicts) {
  using Size = std::array<double, 3>;
  const ReportThing steel{"ball", "sphere", Size{1, 1, 1}, 0, "metal", "hard", {}, 2.0};
  const ReportThing wooden{"ball", "sphere", Size{7, 7, 7}, 0, "wood", "hard", Size{1, 0, 0}, 3.0};
  const Json things = things_of(evidence_, knowing({steel, wooden}));
  ASSERT_EQ(things.size(), 2U);
  EXPECT_EQ(things[0]["size"], Json::array({7.0, 7.0, 7.0}));
  EXPECT_EQ(things[0]["colour"], Json::array({1.0, 0.0, 0.0}));
  EXPECT_EQ(things[0]["mass"], 3.0);
  EXPECT_EQ(things[1]["name"], "cube");
  EXPECT_EQ(things[1]["material"], "wood");
  EXPECT_TRUE(things[1]["shape"].is_null());
  EXPECT_TRUE(things[1]["size"].is_null());
}

// An object of another recording may have the name of a simulated one.
TEST_F(SamplesJson, OnlyWhatASimulatedBodyExploredIsABuiltInThing) {
  const ReportThing ball{"ball", "sphere", {}, 0, "wood", "hard", {}, 0.4};
  EXPECT_TRUE(things_of(evidence_, knowing({}, {ball}))[0]["mass"].is_null());
  exploration(0).source = simulated_source("lucs2", "engine", 1, SimulatedThings::kGiven);
  EXPECT_TRUE(things_of(evidence_, knowing({}, {ball}))[0]["mass"].is_null());
  exploration(0).source = simulated_source("lucs2", "engine", 1, SimulatedThings::kBuiltIn);
  EXPECT_EQ(things_of(evidence_, knowing({}, {ball}))[0]["mass"], 0.4);
  ReportThing own = ball;
  own.mass = 0.5;
  EXPECT_EQ(things_of(evidence_, knowing({own}, {ball}))[0]["mass"], 0.5);
}

TEST_F(SamplesJson, WithoutARecordingTheResultsStateWhatExplored) {
  const ReportThing ball{"ball", "sphere", {}, 0, "wood", "hard", {}, 0.4};
  evidence_.recording = nullptr;
  results_.protocols[0].runs = {{1, {0}, {"ball"}, {"ball"}, {}}};
  EXPECT_TRUE(things_of(evidence_, knowing({}, {ball}))[0]["mass"].is_null());
  results_.recordings[0].source = simulated_source("lucs2", "engine", 1, SimulatedThings::kBuiltIn);
  EXPECT_EQ(things_of(evidence_, knowing({}, {ball}))[0]["mass"], 0.4);
}

TEST_F(SamplesJson, WithoutARecordingThingsAreTheClasses) {
  evidence_.recording = nullptr;
  results_.protocols[0].runs = {{1, {0, 0, 0}, {"b", "a", "b"}, {"b", "a", "b"}, {}}};
  const Json things = things_of(evidence_, {});
  ASSERT_EQ(things.size(), 2U);
  EXPECT_EQ(things[0]["name"], "b");
  results_.protocols[0].label = "shape";
  EXPECT_EQ(things_of(evidence_, {}), Json::array());
}

}  // namespace
}  // namespace somato

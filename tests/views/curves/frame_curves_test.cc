#include "views/curves/frame_curves.h"

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "base/support/json_schema.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

class FrameCurves : public ::testing::Test {
 protected:
  // A part with the alterations "half" and "quarter", and one of another kind.
  PartResults& add(const std::string& system, const std::string& variation = "") {
    PartResults part;
    part.question = "early";
    part.system = system;
    part.variation = variation;
    part.parameters = {{"study", {{"name", "\"x\""}}},
                       {"altered.half", {{"swapped", "[]"}, {"noise", "1.0"}, {"first", "0.5"}}},
                       {"altered.rough", {{"noisy", "[\"touch\"]"}, {"first", "0.75"}}},
                       {"altered.quarter", {{"first", "0.25"}}}};
    for (const char* protocol : {"train_is_test", "leave_group_out"}) {
      part.protocols.push_back({protocol,
                                protocol == std::string("leave_group_out") ? "trial" : "",
                                "object",
                                2,
                                {{"accuracy", {0.75, 1.0}},
                                 {"altered.half.accuracy", {0.5, 0.5}},
                                 {"altered.rough.accuracy", {0.0, 0.0}},
                                 {"altered.quarter.accuracy", {0.25, 0.5}}},
                                {}});
    }
    kept_.push_back(std::move(part));
    return kept_.back();
  }

  // Each checked by its schema.
  Json curves() const {
    std::vector<const PartResults*> parts;
    for (const PartResults& part : kept_) parts.push_back(&part);
    Json curves = detail::frame_curves_json(parts);
    EXPECT_TRUE(testing::fits_schema(curves, "report.json#/$defs/ReportData/properties/curves"));
    return curves;
  }

  std::deque<PartResults> kept_;
};

TEST_F(FrameCurves, HaveALineForEachUnchangedSystem) {
  add("chain");
  add("chain", "another");
  add("leaky");
  const Json json = curves();
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["title"], "accuracy by share of the frames (leave_group_out, trial)");
  ASSERT_EQ(json[0]["lines"].size(), 2U);
  EXPECT_EQ(json[0]["lines"][1]["name"], "leaky");
  const Json& points = json[0]["lines"][0]["points"];
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0]["x"], 0.25);
  EXPECT_EQ(points[0]["mean"], 0.375);
  EXPECT_EQ(points[1]["x"], 0.5);
  EXPECT_EQ(points[2]["x"], 1.0);
  EXPECT_EQ(points[2]["values"], Json::array({0.75, 1.0}));
}

TEST_F(FrameCurves, NeedThreePoints) {
  add("chain").parameters.pop_back();
  EXPECT_TRUE(curves().empty());
}

TEST_F(FrameCurves, AreSeparateForQuestions) {
  add("chain");
  add("chain").question = "late";
  EXPECT_EQ(curves().size(), 2U);
}

}  // namespace
}  // namespace somato

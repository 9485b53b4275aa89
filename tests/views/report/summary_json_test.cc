#include "views/report/summary_json.h"

#include <gtest/gtest.h>

#include "base/support/json_schema.h"
#include "views/report/three_explorations.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

class SummaryJson : public testing::ThreeExplorations {
 protected:
  SummaryJson() {
    ProtocolResults& protocol = results_.protocols[0];
    protocol.protocol = "leave_group_out";
    protocol.group = "material";
    protocol.metrics = {{"accuracy", {1.0 / 3, 1.0 / 3}, {}}};
    const somato::Run run{1, {0, 1, 2}, {"ball", "ball", "cube"}, {"cube", "ball", "ball"}, {}, {}};
    protocol.runs = {run, run};
    sources_.recording_path = [](const std::string& hash) { return hash + ".mcap"; };
  }

  Json summary() const {
    const Json json = detail::summary_json(evidence_, sources_);
    EXPECT_TRUE(testing::fits_schema(json, "report.json#/$defs/SystemReport/properties/summary"));
    return json;
  }

  ReportSources sources_;
};

TEST_F(SummaryJson, HasResultChanceConfusionsAndSteps) {
  const Json json = summary();
  EXPECT_EQ(json["protocol"], 0);
  EXPECT_TRUE(json["baseline"].is_null());
  EXPECT_DOUBLE_EQ(json["chance"].get<double>(), 5.0 / 9);
  ASSERT_EQ(json["confusions"].size(), 2U);
  EXPECT_EQ(json["confusions"][0], Json::parse(R"({"label": "ball", "predicted": "cube",
                                                   "count": 2, "of": 4})"));
  const std::string command = json["next"].back()["commands"][0];
  EXPECT_EQ(command, "somato view 'a hash.mcap'");
}

TEST_F(SummaryJson, IsNullWithoutAnAccuracy) {
  results_.protocols[0].metrics.clear();
  EXPECT_TRUE(summary().is_null());
}

TEST_F(SummaryJson, FoldsOfGroupsAreThoseOfTheRecording) {
  const auto folds = [&] { return detail::folds_of(evidence_, results_.protocols[0]); };
  evidence_.study.emplace();
  exploration(1).labels[1].value = "steel";
  EXPECT_EQ(folds(), (std::vector<std::size_t>{0, 1, 0}));
  results_.protocols[0].group = "trial";
  EXPECT_TRUE(folds().empty());
  results_.protocols[0].protocol = "k_folds";
  evidence_.study->study.folds = 2;
  EXPECT_EQ(folds().size(), 3U);
  results_.recordings.push_back(results_.recordings[0]);
  EXPECT_TRUE(folds().empty());
}

}  // namespace
}  // namespace somato

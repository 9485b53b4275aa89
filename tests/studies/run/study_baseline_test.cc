#include <gtest/gtest.h>

#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::exploration_of;
using testing::outcome_of;
using testing::small_study;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Values = std::vector<double>;

// Two objects, two trials each. `shared` pairs trials across objects, `own` separates objects.
Recording crossed(float shared, float own, std::size_t shared_columns, std::size_t own_columns) {
  Recording recording;
  for (int object = 0; object < 2; ++object) {
    for (int trial = 0; trial < 2; ++trial) {
      std::vector<float> joints(shared_columns, shared * (static_cast<float>(trial) +
                                                          0.01F * static_cast<float>(object)));
      joints.insert(joints.end(), own_columns,
                    own * (static_cast<float>(object) + 0.01F * static_cast<float>(trial)));
      recording.explorations.push_back(exploration_of(std::to_string(object), joints));
    }
  }
  return recording;
}

void expect_baselines(const Recording& recording, double raw, double standardized) {
  for (const std::string standardization : {"", "none"}) {
    const StudyOutcome outcome = outcome_of(small_study(standardization), recording);
    const ProtocolResults& system = system_of(outcome, "leave_one_out");
    EXPECT_EQ(values_of(system, "baseline_accuracy_raw"), (Values{raw, raw}));
    EXPECT_EQ(values_of(system, "baseline_accuracy_standardized"),
              (Values{standardized, standardized}));
    EXPECT_EQ(values_of(system, "baseline_accuracy"), (Values{1, 1}));
  }
}

// The large column decides raw, the greater number of columns when they are standardized.
TEST(Study, TakesTheBetterBaseline) {
  expect_baselines(crossed(100.0F, 1.0F, 1, 3), 0.0, 1.0);
  expect_baselines(crossed(1.0F, 100.0F, 3, 1), 1.0, 0.0);
}

// Whether something stands between a standardization and the map, and how it is made: the baseline
// compares what the map learns, but before a standardization right before it.
void expect_raw_baseline(const std::string& modules, double accuracy) {
  SCOPED_TRACE(modules);
  const StudyDescription description = study_from(
      "[study]\nname = 'small'\nseeds = 1\nprotocols = ['leave_one_out']\n[module.joints]\n"
      "type = 'channel'\nchannel = 'joints'\n[module.closed]\ntype = 'last'\ninput = 'joints'\n" +
      modules + "rows = 3\ncolumns = 3\niterations = 50\n");
  const StudyOutcome outcome = outcome_of(description, crossed(100.0F, 1.0F, 1, 3));
  const ProtocolResults& system = system_of(outcome, "leave_one_out");
  EXPECT_EQ(values_of(system, "baseline_accuracy_raw"), (Values{accuracy}));
  EXPECT_EQ(values_of(system, "baseline_accuracy_standardized"), (Values{1}));
}

TEST(Study, ComparesWhatTheMapLearnsBeforeAStandardizationRightBeforeIt) {
  const std::string standardized =
      "[module.standardized]\ntype = 'standardization'\ninput = 'closed'\n";
  expect_raw_baseline("[module.map]\ntype = 'som'\ninput = 'closed'\n", 0.0);
  expect_raw_baseline(standardized + "[module.map]\ntype = 'som'\ninput = 'standardized'\n", 0.0);
  expect_raw_baseline(standardized +
                          "[module.halved]\ntype = 'scale'\ninput = 'standardized'\nfactor = 0.5\n"
                          "[module.map]\ntype = 'som'\ninput = 'halved'\n",
                      1.0);
}

// The large joint distinguishes trials, the others objects: the baseline has the same input as the
// map.
TEST(Study, TheBaselineSeesWhatTheMapSees) {
  const Recording recording = crossed(100.0F, 1.0F, 1, 3);
  for (const auto& [elements, accuracy] :
       {std::pair{"['1']", 0.0}, std::pair{"['2', '3', '4']", 1.0}}) {
    const StudyDescription description = study_from(
        "[study]\nname = 'small'\nseeds = 1\nprotocols = ['leave_one_out']\n[module.joints]\n"
        "type = 'channel'\nchannel = 'joints'\nelements = " +
        std::string(elements) +
        "\n[module.closed]\ntype = 'last'\ninput = 'joints'\n[module.map]\ntype = 'som'\n"
        "input = 'closed'\nrows = 3\ncolumns = 3\niterations = 50\n");
    const StudyOutcome outcome = outcome_of(description, recording);
    EXPECT_EQ(values_of(system_of(outcome, "leave_one_out"), "baseline_accuracy"),
              (Values{accuracy}));
  }
}

}  // namespace
}  // namespace somato

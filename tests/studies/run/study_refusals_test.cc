#include <gtest/gtest.h>

#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::objects_apart;
using testing::outcome_of;
using testing::small_study;
using testing::study_from;

Recording with_constant_joint() {
  Recording recording = objects_apart(2, 3, 1.0, 4);
  for (Exploration& exploration : recording.explorations) {
    exploration.channels[0].frames(0, 1) = 5.0F;
  }
  return recording;
}

TEST(Study, RefusesAConstantElement) {
  const auto outcome = run_study(small_study(), with_constant_joint());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::kData);
  EXPECT_EQ(outcome.error().where, "study.toml:11, module 'standardized'");
  EXPECT_NE(outcome.error().what.find("2 is 5 in all 6"), std::string::npos)
      << to_string(outcome.error());
}

TEST(Study, RefusesAnElementThatIsConstantInOneTrainingPart) {
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kLeaveOneOut};
  Recording recording = with_constant_joint();
  recording.explorations[4].channels[0].frames(0, 1) = 6.0F;
  const auto outcome = run_study(description, recording);
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.error().what.find("2 is 5 in all 5"), std::string::npos)
      << to_string(outcome.error());
}

TEST(Study, MakesAConstantElementZeroOnRequest) {
  const StudyOutcome outcome =
      outcome_of(small_study("constant_columns = 'zero'\n"), with_constant_joint());
  for (std::size_t neuron = 0; neuron < outcome.map().neurons(); ++neuron) {
    EXPECT_EQ(outcome.map().weights()(neuron, 1), 0.0F);
  }
}

TEST(Study, TakesAConstantElementAsItIsWithoutStandardization) {
  const StudyOutcome outcome = outcome_of(small_study("none"), with_constant_joint());
  for (std::size_t neuron = 0; neuron < outcome.map().neurons(); ++neuron) {
    EXPECT_NEAR(outcome.map().weights()(neuron, 1), 5.0F, 1e-5F);  // means of fives round
  }
}

void expect_refused(const StudyDescription& description, const Recording& recording, ErrorKind kind,
                    const std::string& what) {
  const auto outcome = run_study(description, recording);
  ASSERT_FALSE(outcome) << what;
  EXPECT_EQ(outcome.error().kind, kind);
  EXPECT_NE(outcome.error().what.find(what), std::string::npos) << to_string(outcome.error());
}

// Before anything is trained.
TEST(Study, RefusesRecordingsWithoutAThresholdForUnknownOnes) {
  StudyDescription study = small_study();
  study.study.protocols = {Protocol::kLeaveClassOut};
  study.study.folds = 2;
  Recording named = objects_apart(3, 12, 1.0, 1);
  Recording two = objects_apart(2, 30, 1.0, 1);
  two.explorations.resize(32);
  expect_refused(study, two, ErrorKind::kData, "from 1 training exploration");
  Recording single = named;
  single.explorations.push_back(testing::exploration_of("pear", {1, 2, 3}));
  expect_refused(study, single, ErrorKind::kData, "only one exploration has 'pear'");
  for (std::size_t i = 0; i < 12; ++i) named.explorations[i].labels[0].value = "unknown";
  expect_refused(study, named, ErrorKind::kData, "'unknown' as their 'object'");
  study.study.protocols = {Protocol::kTrainIsTest};
  outcome_of(study, named);
  study.study.unknown = true;
  expect_refused(study, named, ErrorKind::kData, "'unknown' as their 'object'");
  expect_refused(study, objects_apart(3, 6, 1.0, 1), ErrorKind::kData, "from 18 training");
}

TEST(Study, RefusesInvalidLabels) {
  const Recording good = objects_apart(2, 2, 1.0, 1);
  expect_refused(small_study(), {}, ErrorKind::kData, "no explorations");
  expect_refused(small_study(), {{good.explorations[0]}}, ErrorKind::kData, "only one exploration");
  expect_refused(small_study(), objects_apart(1, 3, 1.0, 1), ErrorKind::kData,
                 "every exploration has the same 'object'");
  StudyDescription description = small_study();
  description.study.label = "objects";
  expect_refused(description, good, ErrorKind::kUsage, "unknown label 'objects'");
  description = small_study();
  description.study.individual = "trial";
  expect_refused(description, good, ErrorKind::kUsage, "unknown label 'trial'");
  const std::string study = "[study]\nname = 'n'\nprotocols = ['leave_one_out']\n";
  const auto with_map = [&](const std::string& from, const std::string& more) {
    return study_from(study + "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n" +
                      "[module.closed]\ntype = 'last'\ninput = 'joints'\n" +
                      "[module.map]\ntype = 'som'\ninput = '" + from + "'\n" + more);
  };
  expect_refused(study_from(study + "[module.touch]\ntype = 'channel'\nchannel = 'touch'\n"), good,
                 ErrorKind::kUsage, "unknown channel 'touch'");
  expect_refused(study_from(study + "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"),
                 good, ErrorKind::kUsage, "the system has no output map");
  expect_refused(with_map("closed", "radius_schedule = 'exponential'\nradius_end = 0.0\n"), good,
                 ErrorKind::kUsage, "cannot start or end at 0");
  expect_refused(with_map("joints", ""), good, ErrorKind::kUsage, "receives one per frame");
  description = with_map("closed", "[module.other]\ntype = 'som'\ninput = 'closed'\n");
  expect_refused(description, good, ErrorKind::kUsage, "more than one map could answer");
  description.study.map = "maps";
  expect_refused(description, good, ErrorKind::kUsage, "unknown module of type som 'maps'");
  description.study.map = "closed";
  expect_refused(description, good, ErrorKind::kUsage, "unknown module of type som 'closed'");
}

TEST(Study, RefusesAnIndividualOfTwoClasses) {
  Recording recording = objects_apart(2, 2, 1.0, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    recording.explorations[i].labels.push_back({"thing", i < 3 ? "a" : "b"});
  }
  StudyDescription description = small_study();
  description.study.individual = "thing";
  expect_refused(description, recording, ErrorKind::kData,
                 "explorations with the same 'thing' differ in 'object'");
}

TEST(Study, LeavesOutEachOfTwoGroups) {
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kLeaveGroupOut};
  description.study.groups = {"trial"};
  const auto outcome = run_study(description, testing::grasps(3, 2, 1));
  ASSERT_TRUE(outcome) << to_string(outcome.error());
  EXPECT_EQ(outcome->results.protocols.at(0).group, "trial");
}

TEST(Study, RefusesWhatCannotBeDivided) {
  const Recording good = objects_apart(2, 2, 1.0, 1);
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kFolds};
  description.study.folds = 5;
  expect_refused(description, good, ErrorKind::kData, "4 explorations cannot be divided into 5");
  Recording one_trial = testing::grasps(2, 1, 1);
  description.study.protocols = {Protocol::kLeaveGroupOut};
  description.study.groups = {"trial"};
  expect_refused(description, one_trial, ErrorKind::kData,
                 "every exploration has the same 'trial'");
  description.study.groups = {"session"};
  expect_refused(description, one_trial, ErrorKind::kUsage, "unknown label 'session'");
}

}  // namespace
}  // namespace somato

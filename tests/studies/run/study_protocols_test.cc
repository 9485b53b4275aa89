#include <gtest/gtest.h>

#include <set>

#include "maps/grid/areas.h"
#include "maps/training/batch_training.h"
#include "recordings/explorations/content_hash.h"
#include "recordings/support/made_recording.h"
#include "somato/maps/som_training.h"
#include "studies/measures/wrong_groupings.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::json_of;
using testing::objects_apart;
using testing::outcome_of;
using testing::small_study;
using testing::system_of;
using testing::values_of;
using Numbers = std::vector<std::size_t>;
using Texts = std::vector<std::string>;
using Values = std::vector<double>;

Samples joints_of(const Recording& recording) {
  std::vector<Signal> signals;
  for (const Exploration& exploration : recording.explorations) {
    const auto values = exploration.channels[0].frames.row(0);
    signals.push_back(Signal::dense({values.begin(), values.end()}));
  }
  return Samples::from_signals(signals);
}

StudyOutcome tested_with(const Recording& recording, const Recording& test,
                         const StudyDescription& description = small_study("none")) {
  StudyOptions options;
  options.test_data = &test;
  return outcome_of(description, recording, options);
}

// The winners of the tested recording, computed directly: the map is trained on the other one only.
Numbers winners_by_hand(const Recording& recording, const Recording& test, std::uint64_t seed) {
  SomParameters parameters;
  parameters.rows = 5;
  parameters.columns = 5;
  parameters.iterations = 300;
  parameters.seed = seed;
  const Som map = train_som(parameters, joints_of(recording)).value();
  return winners_of(map, joints_of(test), 1);
}

TEST(TestData, LearnsFromAllOfTheOneAndNothingOfTheOther) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  const Recording test = objects_apart(3, 2, 150.0, 8);
  const StudyOutcome outcome = tested_with(recording, test);
  const ProtocolResults& system = system_of(outcome, "test_data");
  EXPECT_EQ(system.samples, 6U);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(system.runs[s].winners, winners_by_hand(recording, test, 5 + s));
    EXPECT_EQ(system.runs[s].labels,
              (Texts{"object 1", "object 1", "object 2", "object 2", "object 3", "object 3"}));
  }
}

// The content of one test exploration does not affect the answers for the others.
TEST(TestData, NothingThatLearnsLearnsFromIt) {
  const Recording recording = testing::grasps(3, 3, 4);
  Recording test = testing::grasps(3, 2, 8);
  const auto runs_of = [&] {
    return system_of(tested_with(recording, test, testing::learning_study()), "test_data").runs;
  };
  const auto before = runs_of();
  for (float& value : test.explorations[0].channels[0].frames.values())
    value = value * -1e4F + 3e6F;
  const auto after = runs_of();
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t i = 1; i < 6; ++i) {
      EXPECT_EQ(after[s].winners[i], before[s].winners[i]);
      EXPECT_EQ(after[s].predictions[i], before[s].predictions[i]);
    }
  }
}

TEST(TestData, LeavesTheOtherProtocolsAndTheModelAsTheyAre) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  Recording test = objects_apart(3, 2, 150.0, 8);
  test.explorations[0].labels[0].value = "new";
  const StudyOutcome with = tested_with(recording, test);
  const StudyOutcome without = outcome_of(small_study("none"), recording);
  PartResults same = with.results;
  ASSERT_EQ(same.protocols.size(), 3U);
  same.protocols.pop_back();
  EXPECT_EQ(same.recordings.at(0).hash, content_hash(recording));
  ASSERT_EQ(same.test_recordings.size(), 1U);
  EXPECT_EQ(same.test_recordings[0].hash, content_hash(test));
  same.test_recordings.clear();
  EXPECT_EQ(to_json(Results{{same}, {}, {}}), json_of(without));
  EXPECT_EQ(with.map().weights(), without.map().weights());
  EXPECT_EQ(with.winners, without.winners);
  EXPECT_EQ(with.classes.names, (Texts{"object 1", "object 2", "object 3"}));
  EXPECT_EQ(with.model.answer->classes, with.classes.names);
}

TEST(TestData, CountsAClassThatWasNeverLearnedAsWrong) {
  const Recording recording = objects_apart(2, 4, 1.0, 2);
  Recording test = objects_apart(2, 2, 1.0, 8);
  test.explorations[3].labels[0].value = "object 7";
  const ProtocolResults system = system_of(tested_with(recording, test), "test_data");
  EXPECT_EQ(values_of(system, "accuracy"), (Values{0.75, 0.75}));
  EXPECT_EQ(values_of(system, "baseline_accuracy"), (Values{0.75, 0.75}));
  EXPECT_EQ(system.runs[0].labels[3], "object 7");
  EXPECT_EQ(system.runs[0].predictions[3], "object 2");
}

TEST(TestData, DealsWrongGroupingsAmongBothRecordings) {
  const Recording recording = objects_apart(3, 4, 60.0, 1);
  const Recording test = objects_apart(3, 2, 60.0, 2);
  StudyDescription description = small_study("none");
  description.study.wrong_groupings = 40;
  const StudyOutcome outcome = tested_with(recording, test, description);
  Numbers winners = outcome.winners;
  const Numbers others = winners_by_hand(recording, test, 5);
  winners.insert(winners.end(), others.begin(), others.end());
  const WinnerAreas areas(outcome.map().grid(), winners);
  Numbers classes{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 0, 0, 1, 1, 2, 2};
  Numbers individuals(18);
  for (std::size_t i = 0; i < 18; ++i) individuals[i] = i;
  double connected = 0.0;
  for (const Numbers& wrong : wrong_groupings(classes, individuals, 40, 5)) {
    connected += areas.connected(wrong) ? 1.0 : 0.0;
  }
  const ProtocolResults& system = system_of(outcome, "test_data");
  EXPECT_NEAR(values_of(system, "areas_connected_chance")[0], connected / 40.0, 1e-12);
}

void expect_test_data_refused(const Recording& recording, const Recording& test,
                              const std::string& what) {
  StudyOptions options;
  options.test_data = &test;
  const auto outcome = run_study(small_study(), recording, options);
  ASSERT_FALSE(outcome) << what;
  EXPECT_EQ(outcome.error().kind, ErrorKind::kData);
  EXPECT_NE(outcome.error().what.find(what), std::string::npos) << to_string(outcome.error());
}

TEST(TestData, IsRefusedWhenItDoesNotFit) {
  const Recording good = objects_apart(2, 2, 1.0, 1);
  Recording other = objects_apart(2, 1, 1.0, 2);
  for (Exploration& exploration : other.explorations) exploration.channels[0].unit = "rad";
  expect_test_data_refused(good, other, "is in 'rad', but in 'deg'");
  expect_test_data_refused(good, {}, "no explorations");
  // The training data must have two classes by themselves.
  expect_test_data_refused(objects_apart(1, 3, 1.0, 1), good, "every exploration has the same");
  expect_test_data_refused(objects_apart(1, 1, 1.0, 1), good, "only one exploration");
}

// According to the results of the program: each run's winners are those of a map trained on the
// other groups only.
TEST(LeaveGroupOut, LearnsOnlyFromTheOtherGroups) {
  const Recording recording = testing::grasps(3, 3, 4);
  StudyDescription description = testing::learning_study();
  description.study.protocols = {Protocol::kLeaveGroupOut};
  description.study.groups = {"trial"};
  const ProtocolResults groups = system_of(outcome_of(description, recording), "leave_group_out");
  EXPECT_EQ(groups.samples, 9U);
  for (std::size_t trial = 0; trial < 3; ++trial) {
    Recording learned;
    Recording left_out;
    for (std::size_t i = 0; i < 9; ++i) {
      (i % 3 == trial ? left_out : learned).explorations.push_back(recording.explorations[i]);
    }
    StudyDescription plain = testing::learning_study();
    plain.study.protocols = {Protocol::kTrainIsTest};
    const ProtocolResults tested = system_of(tested_with(learned, left_out, plain), "test_data");
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(groups.runs[s].winners[3 * i + trial], tested.runs[s].winners[i]);
        EXPECT_EQ(groups.runs[s].predictions[3 * i + trial], tested.runs[s].predictions[i]);
      }
    }
  }
}

TEST(KFolds, AreDealtBySeedAndLearnFromTheOthers) {
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kFolds, Protocol::kLeaveOneOut};
  description.study.folds = 12;
  description.study.fold_choice = FoldChoice::kInterleaved;
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  const StudyOutcome outcome = outcome_of(description, recording);
  // Twelve parts of twelve samples leave each out.
  const ProtocolResults& parts = system_of(outcome, "k_folds");
  const ProtocolResults& ones = system_of(outcome, "leave_one_out");
  for (std::size_t s = 0; s < 2; ++s) EXPECT_EQ(parts.runs[s].winners, ones.runs[s].winners);
  EXPECT_EQ(values_of(parts, "accuracy"), values_of(ones, "accuracy"));
  description.study.folds = 3;
  std::set<Numbers> winners;
  for (const std::uint64_t first_seed : {5U, 6U}) {
    description.study.first_seed = first_seed;
    winners.insert(
        system_of(outcome_of(description, recording), "k_folds").runs[6 - first_seed].winners);
  }
  EXPECT_EQ(winners.size(), 2U);  // the same seed of the map, other parts
}

}  // namespace
}  // namespace somato

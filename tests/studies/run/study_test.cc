#include "somato/studies/study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/support/temporary_folder.h"
#include "maps/grid/areas.h"
#include "recordings/explorations/content_hash.h"
#include "recordings/support/made_recording.h"
#include "somato/codes/standardization.h"
#include "somato/core/random.h"
#include "somato/graph/system_model.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "studies/measures/wrong_groupings.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::exploration_of;
using testing::json_of;
using testing::objects_apart;

using testing::outcome_of;
using testing::small_study;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Values = std::vector<double>;

TEST(Study, SeparatesDistinctClasses) {
  const StudyOutcome outcome = outcome_of(small_study(), objects_apart(3, 4, 2.0, 1));
  for (const ProtocolResults& system : outcome.results.protocols) {
    EXPECT_EQ(values_of(system, "accuracy"), (Values{1, 1})) << system.protocol;
    EXPECT_EQ(values_of(system, "individuals_apart"), (Values{1, 1})) << system.protocol;
    EXPECT_EQ(values_of(system, "baseline_accuracy"), (Values{1, 1})) << system.protocol;
  }
  EXPECT_EQ(outcome.results.protocols.size(), 2U);
}

// Each of two parts has a sample of both objects, so that each is known when the other is tested.
TEST(Study, DealsEachClassToAllParts) {
  StudyDescription description = small_study();
  description.study.protocols = {Protocol::kFolds};
  description.study.folds = 2;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    description.study.first_seed = seed;
    const StudyOutcome outcome = outcome_of(description, objects_apart(2, 2, 2.0, 1));
    EXPECT_EQ(values_of(system_of(outcome, "k_folds"), "baseline_accuracy"), (Values{1, 1}))
        << seed;
  }
}

Recording noise_with_random_labels(std::size_t samples, std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t i = 0; i < samples; ++i) {
    std::vector<float> joints;
    for (int joint = 0; joint < 4; ++joint) joints.push_back(static_cast<float>(random.normal()));
    recording.explorations.push_back(exploration_of(std::to_string(random.below(4)), joints));
  }
  return recording;
}

// 80 samples of 4 classes: a standard deviation of 0.05 around a quarter for each seed. Held out
// there is nothing to find; a map that is tested on what it learned remembers some of it.
TEST(Study, FindsNothingInNoiseThatIsHeldOut) {
  StudyDescription description = small_study();
  description.study.seeds = 3;
  const StudyOutcome outcome = outcome_of(description, noise_with_random_labels(80, 3));
  const ProtocolResults& held_out = system_of(outcome, "leave_one_out");
  const ProtocolResults& remembered = system_of(outcome, "train_is_test");
  for (std::size_t seed = 0; seed < 3; ++seed) {
    EXPECT_GT(values_of(held_out, "accuracy")[seed], 0.08);
    EXPECT_LT(values_of(held_out, "accuracy")[seed], 0.42);
    EXPECT_GT(values_of(remembered, "accuracy")[seed], 0.42);
    EXPECT_EQ(values_of(remembered, "baseline_accuracy")[seed], 1.0);
  }
}

double share_right(const Run& run) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < run.labels.size(); ++i) {
    if (run.labels[i] == run.predictions[i]) ++right;
  }
  return static_cast<double>(right) / static_cast<double>(run.labels.size());
}

TEST(Study, CountsAccuracyFromItsRuns) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  const StudyOutcome outcome = outcome_of(small_study(), recording);
  for (const ProtocolResults& system : outcome.results.protocols) {
    ASSERT_EQ(system.runs.size(), 2U);
    EXPECT_EQ(system.samples, 12U);
    EXPECT_EQ(system.label, "object");
    Values accuracy;
    for (std::size_t seed = 0; seed < 2; ++seed) {
      const somato::Run& run = system.runs[seed];
      EXPECT_EQ(run.seed, 5 + seed);
      EXPECT_EQ(run.winners.size(), 12U);
      for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(run.labels[i], recording.explorations[i].labels[0].value);
      }
      accuracy.push_back(share_right(run));
    }
    EXPECT_EQ(values_of(system, "accuracy"), accuracy);
  }
  const Values held_out = values_of(system_of(outcome, "leave_one_out"), "accuracy");
  EXPECT_LT(*std::max_element(held_out.begin(), held_out.end()),
            1.0);  // there was something to count
}

// Metrics over folds, recomputed from the map that the study hands out.
TEST(Study, MeasuresTheMapOfTrainIsTest) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  const StudyOutcome outcome = outcome_of(small_study(), recording);
  const ProtocolResults& system = system_of(outcome, "train_is_test");
  EXPECT_EQ(system.runs[0].winners, outcome.winners);
  EXPECT_EQ(outcome_of(small_study("none"), recording).map().parameters().seed, 5U);

  std::vector<Signal> signals;
  for (const Exploration& exploration : recording.explorations) {
    const auto values = exploration.channels[0].frames.row(0);
    signals.push_back(Signal::dense({values.begin(), values.end()}));
  }
  const Samples raw = Samples::from_signals(signals);
  const Samples samples = Standardization::fit(raw)->apply(raw);
  SomParameters parameters;
  parameters.rows = 5;
  parameters.columns = 5;
  parameters.iterations = 300;
  parameters.seed =
      outcome.map().parameters().seed;  // the standardization, which learns too, has 5
  const Som map = train_som(parameters, samples).value();
  EXPECT_EQ(map.weights(), outcome.map().weights());
  SomWorkspace workspace;
  double distance = 0.0;
  double topographic_errors = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    const Winners winners = map.winners(samples[i], workspace);
    distance += map.distance(samples[i], winners.first, workspace);
    topographic_errors += map.grid().adjacent(winners.first, winners.second) ? 0.0 : 1.0;
  }
  EXPECT_NEAR(values_of(system, "quantization_error")[0], distance / 12.0, 1e-9);
  EXPECT_NEAR(values_of(system, "topographic_error")[0], topographic_errors / 12.0, 1e-9);
  const std::vector<std::size_t>& classes = outcome.classes.of_sample;
  const bool apart = individuals_apart(outcome.winners, classes);
  const bool connected = WinnerAreas(map.grid(), outcome.winners).connected(classes);
  EXPECT_EQ(values_of(system, "individuals_apart")[0], apart ? 1.0 : 0.0);
  EXPECT_EQ(values_of(system, "areas_connected")[0], connected ? 1.0 : 0.0);
}

// The map of the second seed is the first of a study that begins with it.
TEST(Study, KeepsTheMapOfEverySeedWhereAllSamplesAreTestedByIt) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  StudyDescription description = small_study();
  const StudyOutcome both = outcome_of(description, recording);
  description.study.first_seed += 1;
  description.study.seeds = 1;
  const StudyOutcome second = outcome_of(description, recording);
  const auto& runs = system_of(both, "train_is_test").runs;
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].map, (TrainedMap{both.map().grid(), u_matrix(both.map()), {}}));
  EXPECT_EQ(runs[1].map, (TrainedMap{second.map().grid(), u_matrix(second.map()), {}}));
  EXPECT_NE(runs[0].map->u_matrix, runs[1].map->u_matrix);
  for (const auto& run : system_of(both, "leave_one_out").runs) EXPECT_FALSE(run.map);
}

std::string saved_system(const StudyOutcome& outcome) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("system"), outcome.model.system, outcome.model.answer));
  return bytes_of(folder.file("system"));
}

void expect_same_for_threads(const StudyDescription& description, const Recording& recording) {
  const StudyOutcome one = outcome_of(description, recording);
  for (const std::size_t threads : {2U, 4U}) {
    StudyOptions options;
    options.threads = threads;
    const StudyOutcome several = outcome_of(description, recording, options);
    EXPECT_EQ(json_of(several), json_of(one)) << threads;
    EXPECT_TRUE(saved_system(several) == saved_system(one)) << threads;
    EXPECT_EQ(several.winners, one.winners) << threads;
  }
}

TEST(Study, GivesTheSameForAnyNumberOfThreads) {
  expect_same_for_threads(small_study(), objects_apart(3, 4, 150.0, 2));
  expect_same_for_threads(testing::learning_study(), testing::grasps(3, 3, 2));
}

TEST(Study, GivesTheSameEveryTimeAndForEverySeedAnother) {
  const Recording recording = objects_apart(3, 4, 150.0, 2);
  const StudyOutcome outcome = outcome_of(small_study(), recording);
  EXPECT_EQ(json_of(outcome_of(small_study(), recording)), json_of(outcome));
  StudyDescription later = small_study();
  later.study.first_seed = 6;
  const StudyOutcome shifted = outcome_of(later, recording);
  for (const char* protocol : {"train_is_test", "leave_one_out"}) {
    const ProtocolResults& runs = system_of(outcome, protocol);
    EXPECT_EQ(system_of(shifted, protocol).runs[0].winners, runs.runs[1].winners);
    EXPECT_NE(runs.runs[0].winners, runs.runs[1].winners);
  }
}

TEST(Study, SaysWhatItRanOn) {
  const Recording recording = objects_apart(3, 4, 2.0, 2);
  const PartResults results = outcome_of(small_study(), recording).results;
  EXPECT_EQ(results.system, "small");
  EXPECT_EQ(results.study, to_toml(small_study()));
  EXPECT_FALSE(results.model);
  ASSERT_EQ(results.pairs.size(), 2U);
  EXPECT_EQ(results.pairs[1].seed, 6U);
  ASSERT_EQ(results.recordings.size(), 1U);
  EXPECT_EQ(results.recordings[0].hash, content_hash(recording));
  EXPECT_EQ(results.recordings[0].explorations, 12U);
  EXPECT_TRUE(results.test_recordings.empty());
  std::vector<std::string> parts;
  for (const Settings& part : results.parameters) parts.push_back(part.part);
  EXPECT_EQ(parts, (std::vector<std::string>{"study", "recording", "module.joints", "module.closed",
                                             "module.standardized", "module.map"}));
}

TEST(Study, SaysItsTextAsItStands) {
  StudyDescription description = small_study();
  description.text = "# As it stands.\n" + to_toml(description);
  EXPECT_EQ(outcome_of(description, objects_apart(3, 4, 2.0, 2)).results.study, description.text);
}

// The setting's value as TOML writes it.
std::string setting(const PartResults& results, const std::string& part, const std::string& name) {
  for (const Settings& settings : results.parameters) {
    if (settings.part != part) continue;
    for (const Setting& candidate : settings.settings) {
      if (candidate.name == name) return candidate.value;
    }
  }
  return "none";
}

TEST(Study, SaysEverySetting) {
  std::string system = testing::joints_system();
  system.erase(system.find("iterations"));  // its phase says how many
  const StudyDescription description =
      study_from("[study]\nname = 'small'\nseeds = 1\n" + system +
                 "[[phase]]\nlearn = ['standardized']\n[[phase]]\nlearn = ['map']\ndraws = 70\n");
  const PartResults results = outcome_of(description, objects_apart(3, 4, 2.0, 2)).results;
  EXPECT_EQ(setting(results, "study", "wrong_groupings"), "20");
  EXPECT_EQ(setting(results, "recording", "format"), "\"automatic\"");
  EXPECT_EQ(setting(results, "module.joints", "type"), "\"channel\"");
  EXPECT_EQ(setting(results, "module.closed", "input"), "\"joints\"");
  EXPECT_EQ(setting(results, "module.standardized", "constant_columns"), "\"refuse\"");
  EXPECT_EQ(setting(results, "module.map", "rows"), "5");
  EXPECT_EQ(setting(results, "module.map", "iterations"), "70");
  EXPECT_EQ(setting(results, "module.map", "seed"), "none");
  EXPECT_EQ(setting(results, "phase.1", "learn"), "[\"standardized\"]");
  EXPECT_EQ(setting(results, "phase.2", "draws"), "70");
  EXPECT_EQ(setting(results, "phase.3", "draws"), "none");
}

// A map's automatic settings are those decided on all training data.
TEST(Study, SaysHowAMapsAutomaticSettingsWereDecided) {
  const StudyDescription description = study_from(
      "[study]\nname = 'small'\nseeds = 1\n[module.joints]\ntype = 'channel'\n"
      "channel = 'joints'\n[module.closed]\ntype = 'last'\ninput = 'joints'\n"
      "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 3\ncolumns = 3\n");
  const Recording recording = objects_apart(3, 4, 2.0, 2);
  const PartResults results = outcome_of(description, recording).results;
  SomParameters parameters;
  parameters.rows = 3;
  parameters.columns = 3;
  const SomParameters decided = resolve(parameters, 12, 3).value();
  for (const auto& parameter : SomParameters::declarations().all()) {
    if (parameter.info.name == "seed") continue;
    EXPECT_EQ(setting(results, "module.map", parameter.info.name),
              to_toml(parameter.read(decided)));
  }
  EXPECT_EQ(setting(results, "module.map", "iterations").find("automatic"), std::string::npos);
}

TEST(Study, UsesTheNamedMap) {
  StudyDescription description = study_from(
      "[study]\nname = 'n'\nseeds = 1\nmap = 'second'\n" + testing::joints_system() +
      "[module.second]\ntype = 'som'\ninput = 'closed'\nrows = 2\ncolumns = 2\niterations = 50\n");
  const Recording recording = objects_apart(3, 4, 2.0, 1);
  const StudyOutcome outcome = outcome_of(description, recording);
  EXPECT_EQ(outcome.model.answer->map, "second");
  EXPECT_EQ(outcome.map().neurons(), 4U);
  description.study.map = "map";
  EXPECT_EQ(outcome_of(description, recording).map().neurons(), 25U);
}

// The share of groupings into wrong classes that have connected areas on the map of the first seed.
double share_connected(const StudyOutcome& outcome, const std::vector<std::size_t>& individuals) {
  const WinnerAreas areas(outcome.map().grid(), outcome.winners);
  const auto wrong = wrong_groupings(outcome.classes.of_sample, individuals, 50, 5);
  const auto connected = std::count_if(
      wrong.begin(), wrong.end(), [&](const auto& classes) { return areas.connected(classes); });
  return static_cast<double>(connected) / 50.0;
}

TEST(Study, DealsIndividualsAsWholes) {
  Recording recording = objects_apart(6, 2, 60.0, 1);
  for (std::size_t i = 0; i < 12; ++i) {
    recording.explorations[i].labels.push_back({"shape", i < 6 ? "round" : "edged"});
  }
  StudyDescription description = small_study();
  description.study.label = "shape";
  description.study.individual = "object";
  description.study.wrong_groupings = 50;
  const StudyOutcome whole = outcome_of(description, recording);
  description.study.individual = "";
  const StudyOutcome single = outcome_of(description, recording);
  const std::string metric = "areas_connected_chance";
  const double whole_share = values_of(system_of(whole, "train_is_test"), metric)[0];
  const double single_share = values_of(system_of(single, "train_is_test"), metric)[0];
  EXPECT_NEAR(whole_share, share_connected(whole, {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}), 1e-12);
  EXPECT_NEAR(single_share, share_connected(single, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), 1e-12);
  EXPECT_NE(whole_share, single_share);
}

TEST(Study, LeavesOutTheMeasureOfWrongGroupingsWhenThereIsNone) {
  StudyDescription description = small_study();
  description.study.wrong_groupings = 0;
  const StudyOutcome outcome = outcome_of(description, objects_apart(2, 3, 1.0, 1));
  for (const ProtocolResults& system : outcome.results.protocols) {
    for (const Metric& metric : system.metrics) {
      EXPECT_NE(metric.name, "areas_connected_chance");
    }
  }
}

// The progress is also called during a training, with the number of preceding trainings.
TEST(Study, ReportsItsProgressTrainingByTraining) {
  std::vector<std::uint64_t> reported;
  StudyOptions options;
  options.progress = [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_EQ(total, 2 * (1 + 6U));  // seeds x (all, and each left out)
    reported.push_back(done);
    return true;
  };
  ASSERT_TRUE(run_study(small_study(), objects_apart(2, 3, 1.0, 1), options));
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  for (std::uint64_t done = 1; done <= 14; ++done) {
    EXPECT_TRUE(std::binary_search(reported.begin(), reported.end(), done)) << done;
  }
  EXPECT_EQ(reported.back(), 14U);
}

void expect_stops(std::size_t threads, std::uint64_t most_reported) {
  std::uint64_t reported = 0;
  StudyOptions options;
  options.threads = threads;
  options.progress = [&](std::uint64_t, std::uint64_t) {
    ++reported;
    return false;
  };
  const auto outcome = run_study(small_study(), objects_apart(3, 10, 1.0, 1), options);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::kInterrupted);
  EXPECT_LE(reported, most_reported);
}

TEST(Study, StopsOnRequest) {
  expect_stops(1, 1);
}

// The trainings under way may end, but none begins.
TEST(Study, StopsOnAllThreadsOnRequest) {
  expect_stops(4, 4);
}

}  // namespace
}  // namespace somato

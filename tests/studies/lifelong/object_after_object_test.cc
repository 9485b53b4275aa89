#include "studies/lifelong/object_after_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/support/temporary_folder.h"
#include "recordings/support/made_recording.h"
#include "somato/graph/further_learning.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::objects_apart;
using testing::outcome_of;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Numbers = std::vector<std::size_t>;
using Values = std::vector<double>;

const std::string kProtocol = "object_after_object";

std::string objects_system(const std::string& kind) {
  return "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
         "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
         "[module.map]\ntype = '" +
         kind + "'\ninput = 'closed'\n" +
         (kind == "som" ? "rows = 4\ncolumns = 4\niterations = 200\n"
                        : "most_neurons = 40\nhabituation_threshold = 2.0\ninsertion_share = 1.0\n"
                          "distance_unit = 50.0\n");
}

const std::string kTwoFolds = "seeds = 2\nfolds = 2\n";

StudyDescription objects_study(const std::string& kind, const std::string& settings = "",
                               const std::string& folds = "seeds = 2\nfolds = 3\n") {
  return study_from(
      "[study]\nname = 'life'\nfirst_seed = 5\nprotocols = ['object_after_object']\n" + folds +
      settings + objects_system(kind));
}

// Noise so large that objects overlap.
Recording overlapping_objects() {
  return objects_apart(4, 6, 300.0, 3);
}

Numbers samples_of_object(const Numbers& samples, std::size_t object) {
  Numbers chosen;
  for (const std::size_t sample : samples) {
    if (sample / 6 == object) chosen.push_back(sample);
  }
  return chosen;
}

std::vector<Fold> three_object_folds(std::uint64_t first_seed) {
  FoldSamples samples;
  samples.samples = 24;
  for (std::size_t i = 0; i < 24; ++i) samples.classes.push_back(i / 6);
  samples.folds = 3;
  samples.seed = first_seed;
  return folds(Protocol::kObjectAfterObject, samples);
}

// The system as a saved model learns it: object by object, with their names.
TEST(ObjectAfterObject, NamesWhatASystemNamesThatLearnsFurther) {
  const Recording recording = overlapping_objects();
  const StudyDescription description = objects_study("growing_when_required");
  const StudyOutcome outcome = outcome_of(description, recording);
  const ProtocolResults& results = system_of(outcome, kProtocol);
  std::size_t wrong = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    const std::uint64_t seed = 5 + s;
    const Numbers order = order_of_objects(4, seed);
    double right = 0.0;
    for (const Fold& fold : three_object_folds(5)) {
      SystemModel model{System::build(description.system, layout_of(recording)).value(), {}};
      const Numbers first = samples_of_object(fold.training, order[0]);
      Activations activations = evaluate_fixed(model.system, recording, {}, 1).value();
      ASSERT_TRUE(train_system(model.system, recording, first, {seed}, activations));
      const Som& som = *som_of(model.system, 2);
      NeuronVotes votes(som.neurons());
      const auto input = [&](std::size_t i) {
        const auto row = testing::frames_of(recording, "joints", i).row(0);
        return std::vector<float>(row.begin(), row.end());
      };
      for (const std::size_t i : first) votes.add(som.winner(input(i)), 0);
      const auto name = [&](std::size_t i) {
        return recording.explorations[i].labels.front().value;
      };
      model.answer = SystemAnswer{"map", "object", {name(first[0])}, votes.labels(), votes};
      for (std::size_t k = 1; k < 4; ++k) {
        ASSERT_TRUE(
            learn_further(model, recording, samples_of_object(fold.training, order[k]), {seed}));
      }
      SomWorkspace workspace;
      for (const std::size_t i : fold.test) {
        const std::vector<float> tested = input(i);
        const std::string named = model.answer->classes[model.answer->labels.classify(
            *som_of(model.system, 2), SignalView::dense(tested), workspace)];
        EXPECT_FALSE(results.runs[s].map);  // each fold has another one
        EXPECT_EQ(results.runs[s].predictions[i], named);
        EXPECT_EQ(results.runs[s].labels[i], name(i));
        right += named == name(i) ? 1.0 : 0.0;
      }
    }
    EXPECT_DOUBLE_EQ(values_of(results, "accuracy")[s], right / 24.0);
    wrong += right < 24.0 ? 1 : 0;
  }
  EXPECT_GT(wrong, 0U);  // otherwise nothing was compared
}

// A slow oracle: the nearest training sample among the objects so far, for each stage and object.
TEST(ObjectAfterObject, ComparesWithANearestNeighbourThatKeepsEverything) {
  const Recording recording = overlapping_objects();
  const StudyOutcome outcome = outcome_of(objects_study("som"), recording);
  const ProtocolResults& results = system_of(outcome, kProtocol);
  for (std::size_t s = 0; s < 2; ++s) {
    const Numbers order = order_of_objects(4, 5 + s);
    std::vector<Values> share(4, Values(4, 0.0));  // stage, object
    for (const Fold& fold : three_object_folds(5)) {
      for (std::size_t stage = 0; stage < 4; ++stage) {
        for (std::size_t object = 0; object <= stage; ++object) {
          for (const std::size_t test : samples_of_object(fold.test, order[object])) {
            double nearest = std::numeric_limits<double>::infinity();
            std::size_t named = 0;
            for (const std::size_t known : fold.training) {
              const auto learned = std::find(order.begin(), order.end(), known / 6);
              if (static_cast<std::size_t>(learned - order.begin()) > stage) continue;
              double distance = 0.0;
              for (std::size_t j = 0; j < 3; ++j) {
                const double d = double{testing::frames_of(recording, "joints", test)(0, j)} -
                                 double{testing::frames_of(recording, "joints", known)(0, j)};
                distance += d * d;
              }
              if (distance >= nearest) continue;
              nearest = distance;
              named = known / 6;
            }
            share[stage][object] += named == order[object] ? 1.0 / 6.0 : 0.0;
          }
        }
      }
    }
    double forgotten = 0.0;
    for (std::size_t object = 0; object < 3; ++object) {
      double best = 0.0;
      for (std::size_t stage = object; stage < 3; ++stage) {
        best = std::max(best, share[stage][object]);
      }
      forgotten += (best - share[3][object]) / 3.0;
    }
    const Values& last = share[3];
    EXPECT_NEAR(values_of(results, "baseline_accuracy")[s],
                (last[0] + last[1] + last[2] + last[3]) / 4.0, 1e-12);
    EXPECT_NEAR(values_of(results, "baseline_accuracy_after_2")[s],
                (share[1][0] + share[1][1]) / 2.0, 1e-12);
    EXPECT_NEAR(values_of(results, "baseline_forgetting")[s], forgotten, 1e-12);
    EXPECT_EQ(values_of(results, "baseline_values_kept")[s], 16.0 * 3.0);  // of 24, 16 are learned
    EXPECT_LT(last[0] + last[1] + last[2] + last[3], 3.9);
  }
}

// Laws on objects that are 100 apart, with noise of 4.
TEST(ObjectAfterObject, ForgetsLessWithReplay) {
  const Recording recording = objects_apart(5, 4, 4.0, 2);
  const auto results = [&](const std::string& settings) {
    return system_of(
        outcome_of(objects_study("som", settings, "seeds = 1\nfolds = 2\n"), recording), kProtocol);
  };
  const ProtocolResults plain = results("");
  const ProtocolResults replayed = results("replay_per_object = 2\n");
  const ProtocolResults generated = results("generated_per_object = 8\n");
  const double forgotten = values_of(plain, "forgetting").front();
  EXPECT_GT(forgotten, 0.2);
  EXPECT_LT(values_of(replayed, "forgetting").front(), forgotten);
  EXPECT_LT(values_of(generated, "forgetting").front(), forgotten);
  EXPECT_EQ(values_of(plain, "values_kept").front(), 16.0 * 3.0);
  EXPECT_EQ(values_of(replayed, "values_kept").front(), (16.0 + 5.0 * 2.0) * 3.0);
  EXPECT_EQ(values_of(generated, "values_kept").front(), 16.0 * 3.0);  // neurons only
}

TEST(ObjectAfterObject, LearnsTheObjectsOfEachSeedInAnotherOrder) {
  std::set<Numbers> orders;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Numbers order = order_of_objects(3, seed);
    orders.insert(order);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (Numbers{0, 1, 2}));
  }
  EXPECT_EQ(orders.size(), 6U);
}

TEST(ObjectAfterObject, IsTheSameForAnyNumberOfThreadsAndAfterAnInterruption) {
  const Recording recording = objects_apart(3, 4, 300.0, 3);
  const StudyDescription description =
      objects_study("growing_when_required", "replay_per_object = 1\n", kTwoFolds);
  const auto whole = testing::json_of(outcome_of(description, recording));
  StudyOptions options;
  options.threads = 3;
  EXPECT_EQ(testing::json_of(outcome_of(description, recording, options)), whole);
  const TemporaryFolder folder;
  options = {};
  options.journal = folder.file("journal");
  options.progress = [](std::uint64_t done, std::uint64_t) { return done < 2; };
  const auto stopped = run_study(description, recording, options);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  options.progress = {};
  EXPECT_EQ(testing::json_of(outcome_of(description, recording, options)), whole);
}

TEST(ObjectAfterObject, RefusesAnObjectThatIsExploredOnce) {
  Recording recording = overlapping_objects();
  recording.explorations.push_back(testing::exploration_of("pear", {1, 2, 3}));
  const auto refused = run_study(objects_study("som"), recording);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("'pear'"), std::string::npos);
}

// Objects that only the test recording has are not learned.
TEST(ObjectAfterObject, IsTheSameWithTestDataOfOtherObjects) {
  const Recording test = objects_apart(5, 2, 300.0, 8);
  const auto objects_of = [&](const Recording* other) {
    StudyOptions options;
    options.test_data = other;
    const StudyOutcome outcome = outcome_of(objects_study("growing_when_required", "", kTwoFolds),
                                            overlapping_objects(), options);
    const ProtocolResults& results = system_of(outcome, kProtocol);
    return std::pair(testing::values_of(results, "accuracy"),
                     testing::values_of(results, "forgetting"));
  };
  EXPECT_EQ(objects_of(&test), objects_of(nullptr));
}

TEST(ObjectAfterObject, RefusesSettingsThatItDoesNotRead) {
  const auto refused = [](const std::string& settings) {
    const auto read = read_study(
        parse_toml("[study]\nname = 'x'\n" + settings + objects_system("som"), "x.toml").value());
    return read ? std::string() : to_string(read.error());
  };
  EXPECT_NE(refused("replay_per_object = 2\n").find("object_after_object"), std::string::npos);
  EXPECT_NE(refused("generated_spread = 0.2\n").find("object_after_object"), std::string::npos);
  EXPECT_NE(refused("protocols = ['object_after_object']\nrecall = 'map'\n").find("recall"),
            std::string::npos);
  EXPECT_NE(refused("protocols = ['object_after_object']\nreplay_per_object = -1\n"), "");
  EXPECT_NE(refused("protocols = ['object_after_object']\nreplay_choice = 'best'\n"), "");
  EXPECT_NE(refused("protocols = ['object_after_object']\ngenerated_spread = nan\n"), "");
}

}  // namespace
}  // namespace somato

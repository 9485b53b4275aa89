#include "somato/studies/alteration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/files/toml_file.h"
#include "recordings/support/made_recording.h"
#include "somato/studies/study.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::exploration_of;
using testing::objects_apart;
using testing::outcome_of;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Values = std::vector<double>;

Result<std::vector<Alteration>> read_alterations(const std::string& toml) {
  return read_alterations(parse_toml(toml, "study.toml").value());
}

std::string message_of(const std::string& toml) {
  const auto alterations = read_alterations(toml);
  return alterations ? "" : to_string(alterations.error());
}

// Two channels of five frames: `joints` counts from `first`, `touch` has two equal elements.
Exploration counting(const std::string& object, float first, float touch) {
  Matrix<float> joints(5, 1);
  for (std::size_t frame = 0; frame < 5; ++frame)
    joints(frame, 0) = first + static_cast<float>(frame);
  return {{{"object", object}},
          "made",
          {{"joints", "deg", {}, std::move(joints), {}},
           {"touch", "N", {}, Matrix<float>(5, 2, touch), {0.0, 0.1, 0.2, 0.3, 0.4}}}};
}

Recording counting_recording() {
  return {{counting("ball", 0, 1), counting("ball", 10, 2), counting("cube", 20, 3)}};
}

std::vector<Exploration> altered_by(const Alteration& alteration,
                                    const Recording& recording = counting_recording()) {
  return altered(recording, alteration, "object").value();
}

TEST(Alteration, IsReadWithItsNameAndWrittenBack) {
  const std::string text =
      "[altered.half]\nfirst = 0.5\n[altered.rough]\nnoisy = ['sound', 'touch']\nnoise = 2.0\n"
      "[altered.mute]\nmissing = 'sound'\n[altered.odd]\nswapped = ['touch']\n";
  const auto alterations = read_alterations(text).value();
  ASSERT_EQ(alterations.size(), 4U);
  EXPECT_EQ(alterations[0].name, "half");
  EXPECT_EQ(alterations[0].first, 0.5);
  EXPECT_EQ(alterations[1].noisy, (std::vector<std::string>{"sound", "touch"}));
  EXPECT_EQ(alterations[1].noise, 2.0);
  EXPECT_EQ(alterations[2].missing, std::vector<std::string>{"sound"});
  EXPECT_EQ(to_toml(read_alterations(to_toml(alterations)).value()), to_toml(alterations));
  EXPECT_NE(to_toml(alterations).find("[altered.odd]\nswapped = [\"touch\"]"), std::string::npos);
}

TEST(Alteration, ThatHasNoEffectIsRefused) {
  EXPECT_NE(message_of("[altered.none]\n").find("changes nothing"), std::string::npos);
  EXPECT_NE(message_of("[altered.x]\nnoise = 2.0\nfirst = 0.5\n").find("no effect without"),
            std::string::npos);
  EXPECT_NE(message_of("[altered]\nfirst = 0.5\n").find("must be a named table"),
            std::string::npos);
  EXPECT_NE(message_of("altered = 1\n").find("must be a named table"), std::string::npos);
  EXPECT_NE(message_of("[altered.x]\nfirts = 0.5\n").find("'first'"), std::string::npos);
  for (const char* share : {"0.0", "1.5", "-1"}) {
    EXPECT_NE(message_of(std::string("[altered.x]\nfirst = ") + share), "") << share;
  }
}

TEST(Alteration, KeepsTheFirstFramesOfEachChannel) {
  for (const auto& [share, frames] : std::vector<std::pair<double, std::size_t>>{
           {0.01, 1}, {0.2, 1}, {0.21, 2}, {0.5, 3}, {0.8, 4}, {0.81, 5}}) {
    for (const Exploration& exploration : altered_by({.name = "short", .first = share})) {
      EXPECT_EQ(exploration.channels[0].frames.rows(), frames) << share;
      EXPECT_EQ(exploration.channels[1].times.size(), frames) << share;
    }
  }
  const auto halves = altered_by({.name = "short", .first = 0.5});
  EXPECT_EQ(halves[1].channels[0].frames, Matrix<float>(3, 1, {10, 11, 12}));
  EXPECT_EQ(halves[1].labels, counting_recording().explorations[1].labels);
  EXPECT_TRUE(validate(Recording{halves}));
}

TEST(Alteration, SilencesMissingChannelsOnly) {
  const auto silent = altered_by({.name = "mute", .missing = {"touch"}});
  for (std::size_t i = 0; i < silent.size(); ++i) {
    EXPECT_EQ(silent[i].channels[1].frames, Matrix<float>(5, 2, 0.0F));
    EXPECT_EQ(silent[i].channels[0], counting_recording().explorations[i].channels[0]);
  }
}

// The cube is the only exploration of its class: both balls receive its readings.
TEST(Alteration, SwapsReadingsWithThoseOfAnotherClass) {
  const auto swapped = altered_by({.name = "odd", .swapped = {"touch"}});
  EXPECT_EQ(swapped[0].channels[1].frames, Matrix<float>(5, 2, 3.0F));
  EXPECT_EQ(swapped[1].channels[1].frames, Matrix<float>(5, 2, 3.0F));
  EXPECT_LE(swapped[2].channels[1].frames(0, 0), 2.0F);
  EXPECT_EQ(swapped[1].channels[0], counting_recording().explorations[1].channels[0]);
}

TEST(Alteration, KeepsTheNumberOfFramesWhenReadingsAreSwapped) {
  Recording recording = counting_recording();
  recording.explorations[2].channels[0].frames =
      Matrix<float>(10, 1, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  const auto swapped = altered_by({.name = "odd", .swapped = {"joints"}}, recording);
  EXPECT_EQ(swapped[0].channels[0].frames, Matrix<float>(5, 1, {0, 2, 4, 6, 8}));
  EXPECT_EQ(swapped[2].channels[0].frames.rows(), 10U);
}

// A signal with a rate, such as sound, has no frames that belong to those of other channels.
TEST(Alteration, TakesSignalsWithARateAsTheyAre) {
  Recording recording = counting_recording();
  for (Exploration& exploration : recording.explorations) exploration.channels[0].rate = 8192.0;
  recording.explorations[2].channels[0].frames = Matrix<float>(3, 1, {7, 8, 9});
  const auto swapped = altered_by({.name = "odd", .swapped = {"joints"}}, recording);
  EXPECT_EQ(swapped[0].channels[0].frames, Matrix<float>(3, 1, {7, 8, 9}));
}

TEST(Alteration, AddsNoiseInDeviationsOfEachElement) {
  Recording recording;
  for (int i = 0; i < 400; ++i) recording.explorations.push_back(counting("ball", 0, 5));
  const auto noisy =
      altered_by({.name = "rough", .noisy = {"joints", "touch"}, .noise = 3.0}, recording);
  double sum = 0.0;
  double squares = 0.0;
  for (const Exploration& exploration : noisy) {
    EXPECT_EQ(exploration.channels[1].frames, Matrix<float>(5, 2, 5.0F));  // without deviation
    for (std::size_t frame = 0; frame < 5; ++frame) {
      const double noise = static_cast<double>(exploration.channels[0].frames(frame, 0)) -
                           static_cast<double>(frame);
      sum += noise;
      squares += noise * noise;
    }
  }
  // The frames 0 to 4 have the variance 2: the noise has 9 times as much, over 2000 draws.
  EXPECT_NEAR(sum / 2000, 0.0, 4 * std::sqrt(18.0 / 2000));
  EXPECT_NEAR(squares / 2000, 18.0, 4 * 18.0 * std::sqrt(2.0 / 2000));
  EXPECT_EQ(noisy,
            altered_by({.name = "rough", .noisy = {"joints", "touch"}, .noise = 3.0}, recording));
}

TEST(Alteration, NamesWhatItDoesNotFind) {
  const Alteration alteration{.name = "odd", .where = "study.toml:3", .swapped = {"tuoch"}};
  const auto unknown = altered(counting_recording(), alteration, "object");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().where, "study.toml:3");
  EXPECT_NE(to_string(unknown.error()).find("'touch'"), std::string::npos);
  const auto alike = altered({{counting("ball", 0, 1), counting("ball", 1, 1)}},
                             {.name = "odd", .swapped = {"touch"}}, "object");
  ASSERT_FALSE(alike);
  EXPECT_EQ(alike.error().kind, ErrorKind::kData);
}

// Objects far apart, which the joints are sufficient to distinguish.
StudyDescription altered_study() {
  return study_from(
      "[study]\nname = 'small'\nseeds = 2\n"
      "[altered.contradicting]\nswapped = ['joints']\n[altered.short]\nfirst = 0.5\n" +
      testing::joints_system());
}

TEST(AlteredStudy, MeasuresAlteredTestExplorations) {
  const StudyOutcome outcome = outcome_of(altered_study(), objects_apart(3, 4, 2.0, 1));
  for (const ProtocolResults& system : outcome.results.protocols) {
    EXPECT_EQ(values_of(system, "accuracy"), (Values{1, 1})) << system.protocol;
    for (const char* metric : {"accuracy", "baseline_accuracy"}) {
      const std::string altered = std::string("altered.contradicting.") + metric;
      EXPECT_EQ(values_of(system, altered), (Values{0, 0})) << system.protocol;
      // There is one frame, which is always kept.
      EXPECT_EQ(values_of(system, std::string("altered.short.") + metric), (Values{1, 1}));
    }
  }
}

// Nothing is learned from altered explorations, where all modules learn.
TEST(AlteredStudy, LeavesTrainingUnchanged) {
  const Recording recording = testing::grasps(3, 3, 4);
  StudyDescription description = testing::learning_study();
  const StudyOutcome unaltered = outcome_of(description, recording);
  description.altered = {{.name = "noisy", .noisy = {"joints"}}, {.name = "short", .first = 0.5}};
  const StudyOutcome outcome = outcome_of(description, recording);
  ASSERT_EQ(outcome.results.protocols.size(), unaltered.results.protocols.size());
  for (std::size_t i = 0; i < outcome.results.protocols.size(); ++i) {
    for (const Metric& metric : unaltered.results.protocols[i].metrics) {
      EXPECT_EQ(values_of(outcome.results.protocols[i], metric.name), metric.values) << metric.name;
    }
    EXPECT_FALSE(values_of(outcome.results.protocols[i], "altered.short.accuracy").empty());
  }
}

// A short exploration is the same as one that was recorded short.
TEST(AlteredStudy, EvaluatesWhatAShorterRecordingWouldYield) {
  const Recording recording = testing::grasps(3, 4, 6);
  StudyDescription description = testing::learning_study();
  description.study.protocols = {Protocol::kTrainIsTest};
  description.altered = {{.name = "short", .first = 0.5}};
  Recording cut{altered(recording, description.altered.front(), "object").value()};
  StudyOptions options;
  options.test_data = &cut;
  const StudyOutcome outcome = outcome_of(description, recording, options);
  EXPECT_EQ(values_of(system_of(outcome, "train_is_test"), "altered.short.accuracy"),
            values_of(system_of(outcome, "test_data"), "accuracy"));
}

}  // namespace
}  // namespace somato

#include "views/teaching/map_training.h"

#include <gtest/gtest.h>

#include <cmath>

#include "views/live/view_systems.h"

namespace somato::live {
namespace {

const auto kShouldContinue = [] { return true; };

std::vector<TrainingSnapshot> looks_at(const std::string& text) {
  const Recording recording = testing::hand_recording(6, 2);
  std::vector<TrainingSnapshot> looks;
  const auto trained = train_visibly(
      testing::view_system(text), recording, 1,
      [&](const TrainingSnapshot& look) {
        looks.push_back(look);
        return true;
      },
      kShouldContinue);
  EXPECT_TRUE(trained);
  return looks;
}

TEST(MapTraining, ShowsAHundredLooksAndTheLast) {
  const auto looks = looks_at(testing::crossed_system());
  ASSERT_EQ(looks.size(), 101U);
  EXPECT_TRUE(looks.back().done);
  EXPECT_EQ(looks[99].step, 200U);
  EXPECT_EQ(looks[0].steps, 200U);
  EXPECT_EQ(looks[0].winners.size(), 6U);
  EXPECT_EQ(looks[0].classes[1], "cube");
  EXPECT_EQ(looks[0].u_matrix.size(), 12U);
  EXPECT_GT(looks[0].radius, looks[99].radius);
}

// Looking changes nothing.
TEST(MapTraining, LearnsWhatTrainingAsAWholeLearns) {
  const Recording recording = testing::hand_recording(6, 2);
  for (const std::string& text :
       {testing::crossed_system(), testing::sound_system(), testing::two_maps_system()}) {
    const auto visible = testing::trained_model(text, recording);
    const System whole = testing::trained(testing::build(text, recording), recording, 6, 1);
    const std::size_t map = *whole.find("map");
    const Som& expected = *som_of(whole, map);
    const Som& som = *som_of(visible->system, map);
    EXPECT_EQ(som.weights(), expected.weights());
    EXPECT_EQ(som.elements(), expected.elements());
  }
}

// Its threshold comes from trainings without these explorations, of which the map knows nothing.
TEST(MapTraining, FindsAThresholdForUnknownExplorations) {
  EXPECT_FALSE(testing::trained_model(testing::crossed_system(), testing::hand_recording(6, 2))
                   ->answer->novelty);
  const auto model =
      testing::trained_model(testing::crossed_system(), testing::hand_recording(20, 2));
  const auto& novelty = model->answer->novelty;
  ASSERT_TRUE(novelty);
  EXPECT_EQ(novelty->samples, 20U);
  EXPECT_EQ(novelty->false_alarm_rate, 0.05);
  EXPECT_EQ(novelty->scales.size(), model->answer->classes.size());
  EXPECT_GT(novelty->threshold, 1.0) << "explorations are farther from maps without them";
}

TEST(MapTraining, HasTheSameBitsEachTime) {
  const Recording recording = testing::hand_recording(6, 2);
  const auto a = testing::trained_model(testing::crossed_system(), recording);
  const auto b = testing::trained_model(testing::crossed_system(), recording);
  const std::size_t map = *a->system.find("map");
  EXPECT_EQ(som_of(a->system, map)->weights(), som_of(b->system, map)->weights());
}

TEST(MapTraining, LabelsItsNeuronsByMajority) {
  const Recording recording = testing::hand_recording(6, 2);
  const auto model = testing::trained_model(testing::crossed_system(), recording);
  EXPECT_EQ(model->answer->map, "map");
  EXPECT_EQ(model->answer->label, "object");
  EXPECT_EQ(model->answer->classes, (std::vector<std::string>{"ball", "cube"}));
  EXPECT_FALSE(model->answer->labels.labelled().empty());
}

TEST(MapTraining, StopsOnRequest) {
  const Recording recording = testing::hand_recording(6, 2);
  int looks = 0;
  const auto trained = train_visibly(
      testing::view_system(testing::crossed_system()), recording, 1,
      [&](const TrainingSnapshot&) { return ++looks < 3; }, kShouldContinue);
  ASSERT_FALSE(trained);
  EXPECT_EQ(trained.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(looks, 3);
}

TEST(MapTraining, StopsBetweenExplorationsThatItEvaluates) {
  const Recording recording = testing::hand_recording(6, 2);
  int looks = 0;
  int checks = 0;
  const auto trained = train_visibly(
      testing::view_system(testing::crossed_system()), recording, 1,
      [&](const TrainingSnapshot&) { return ++looks > 0; }, [&] { return ++checks < 3; });
  ASSERT_FALSE(trained);
  EXPECT_EQ(trained.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(looks, 0);
  EXPECT_EQ(checks, 3);
}

TEST(MapTraining, NeedsTwoClasses) {
  Recording recording = testing::hand_recording(6, 2);
  for (Exploration& one : recording.explorations) one.labels = {{"object", "ball"}};
  const auto trained = train_visibly(
      testing::view_system(testing::crossed_system()), recording, 1,
      [](const TrainingSnapshot&) { return true; }, kShouldContinue);
  ASSERT_FALSE(trained);
  EXPECT_EQ(trained.error().kind, ErrorKind::kData);
}

}  // namespace
}  // namespace somato::live

#include "live/system_reading.h"

#include <gtest/gtest.h>

#include "live/timeline.h"
#include "live/view_systems.h"

namespace somato::live {
namespace {

std::vector<std::size_t> frames_at(const Timeline& timeline, const Exploration& exploration,
                                   std::size_t moment) {
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    frames.push_back(timeline.frames(i, moment));
  }
  return frames;
}

// What the map sees of an exploration, by evaluating it as a whole.
struct Whole {
  const System& system;
  Recording recording;
  std::size_t map;
  Activations activations{system.modules().size(), 1};

  SignalView last(std::size_t module) {
    const std::vector<std::size_t> only{0};
    EXPECT_TRUE(evaluate(system, recording, only, {module}, 1, activations));
    const Samples& values = activations.find(module, 0)->values;
    return values[values.count() - 1];
  }
  SignalView input_of(std::size_t module) { return last(system.modules()[module].inputs.front()); }
};

void expect_as_whole(const Saying& saying, const SystemModel& model, Whole& whole) {
  SomWorkspace workspace;
  for (const auto& [module, output] : saying.modules) {
    const SignalView expected = whole.last(module);
    ASSERT_FALSE(output.folded);
    std::vector<float> values(expected.size);
    write_dense(expected, values);
    ASSERT_EQ(output.values.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(output.values[i], values[i], 1e-5);
  }
  for (const auto& [module, map] : saying.maps) {
    const Som& som = *som_of(model.system, module);
    const SignalView input = whole.input_of(module);
    EXPECT_NEAR(som.distance(input, map.winner, workspace),
                som.distance(input, som.winner(input, workspace), workspace), 1e-5);
    EXPECT_FLOAT_EQ(*std::max_element(map.activity.begin(), map.activity.end()), 1.0F);
  }
  const Som& som = *som_of(model.system, whole.map);
  const SignalView input = whole.input_of(whole.map);
  const std::size_t answer = model.answer->labels.classify(som, input, workspace);
  ASSERT_FALSE(saying.candidates.empty());
  EXPECT_EQ(saying.candidates.front().number, answer);
}

void expect_says_what_evaluating_says(const std::string& text, std::size_t maps) {
  SCOPED_TRACE(text);
  Recording recording = testing::hand_recording(6, 3);
  auto model = testing::trained_model(text, recording);
  auto reading = SystemReading::build(model).value();
  std::size_t said = 0;
  for (const Exploration& exploration : recording.explorations) {
    const Timeline timeline(exploration);
    reading.start();
    for (std::size_t moment = 0; moment < timeline.moments(); ++moment) {
      const auto cut = [&] { return cut_at(exploration, timeline, moment); };
      ASSERT_TRUE(reading.follow(exploration, frames_at(timeline, exploration, moment)));
      const auto saying = reading.say(cut);
      if (!saying || !*saying) continue;
      ++said;
      EXPECT_EQ((*saying)->maps.size(), maps);
      Whole whole{model->system, {{cut()}}, reading.map()};
      expect_as_whole(**saying, *model, whole);
    }
  }
  EXPECT_GE(said, 2 * recording.explorations.size());
}

TEST(SystemReading, SaysWhatEvaluatingTheExplorationSoFarSays) {
  expect_says_what_evaluating_says(testing::crossed_system(), 1);
  expect_says_what_evaluating_says(testing::two_maps_system(), 2);
  expect_says_what_evaluating_says(testing::sound_system(), 1);
}

TEST(SystemReading, ShowsEveryModule) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reading =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  EXPECT_FALSE(reading.is_costly());
  reading.start();
  ASSERT_TRUE(reading.follow(recording.explorations[0], {2, 2, 2, 2, 0}));
  const Saying saying = **reading.say({});
  // Two channels, code, product, memory and unit; the map is among the maps.
  EXPECT_EQ(saying.modules.size(), 6U);
  EXPECT_EQ(saying.maps.size(), 1U);
}

TEST(SystemReading, IsCostlyWhereExplorationsAreNeededAsAWhole) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reading =
      SystemReading::build(testing::trained_model(testing::sound_system(), recording)).value();
  EXPECT_TRUE(reading.is_costly());
}

// A value that is missing makes this exploration costly alone, and only where the system hears it.
TEST(SystemReading, FollowsLiveAgainAfterAnExplorationWithGaps) {
  Recording recording = testing::hand_recording(6, 3);
  auto reading =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  const auto costs = [&](const char* name) {
    Exploration exploration = recording.explorations[0];
    for (Channel& channel : exploration.channels) {
      if (channel.name != name) continue;
      channel.valid = Matrix<std::uint8_t>(channel.frames.rows(), channel.frames.columns(), 1);
    }
    reading.start();
    EXPECT_TRUE(reading.follow(exploration, {2, 2, 2, 2, 2}));
    EXPECT_TRUE(*reading.say([&] { return exploration; }));
    return reading.is_costly();
  };
  EXPECT_TRUE(costs("touch"));
  EXPECT_FALSE(costs("none"));
  EXPECT_FALSE(costs("sound"));
}

TEST(SystemReading, SaysNothingBeforeThereWasAFrame) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reading =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  reading.start();
  ASSERT_TRUE(reading.follow(recording.explorations[0], {0, 0, 0, 0, 0}));
  EXPECT_FALSE(*reading.say({}));
}

TEST(SystemReading, RefusesWhatDoesNotFit) {
  Recording recording = testing::hand_recording(6, 3);
  auto reading =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  Exploration other = recording.explorations[0];
  other.channels[2].name = "elbows";
  reading.start();
  EXPECT_FALSE(reading.follow(other, {1, 1, 1, 1, 1}));
  other = recording.explorations[0];
  other.channels[2].frames = Matrix<float>(2, 5);
  reading.start();
  EXPECT_FALSE(reading.follow(other, {1, 1, 1, 1, 1}));
  EXPECT_FALSE(SystemReading::build(std::make_shared<SystemModel>()));
}

TEST(Saying, IsSureWhenTheNextClassIsFar) {
  Saying saying;
  EXPECT_EQ(saying.confidence(), 0.0);
  saying.candidates = {{0, 1.0}};
  EXPECT_EQ(saying.confidence(), 1.0);
  saying.candidates = {{0, 1.0}, {1, 4.0}};
  EXPECT_EQ(saying.confidence(), 0.75);
  saying.candidates = {{0, 2.0}, {1, 2.0}};
  EXPECT_EQ(saying.confidence(), 0.0);
}

}  // namespace
}  // namespace somato::live

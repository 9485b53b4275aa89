#include "views/session/system_reading.h"

#include <gtest/gtest.h>

#include "views/live/view_systems.h"
#include "views/replay/timeline.h"

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

// As far as it went: hand_recording() has neither times nor marks of validity.
Exploration cut_at(Exploration exploration, const std::vector<std::size_t>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Channel& channel = exploration.channels[i];
    EXPECT_TRUE(channel.times.empty() && channel.valid.empty());
    const auto kept = channel.frames.values().first(frames[i] * channel.frames.columns());
    channel.frames = Matrix<float>(frames[i], channel.frames.columns(),
                                   std::vector<float>(kept.begin(), kept.end()));
  }
  return exploration;
}

// The map's input of an exploration, by evaluating it as a whole.
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

void expect_as_whole(const Reading& reading, const SystemModel& model, Whole& whole) {
  SomWorkspace workspace;
  for (const auto& [module, output] : reading.modules) {
    const SignalView expected = whole.last(module);
    ASSERT_FALSE(output.folded);
    std::vector<float> values(expected.size);
    write_dense(expected, values);
    ASSERT_EQ(output.values.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(output.values[i], values[i]);
  }
  for (const auto& [module, map] : reading.maps) {
    const Som& som = *som_of(model.system, module);
    const SignalView input = whole.input_of(module);
    EXPECT_EQ(map.winner, som.winner(input, workspace));
    EXPECT_FLOAT_EQ(*std::max_element(map.activity.begin(), map.activity.end()), 1.0F);
  }
  const Som& som = *som_of(model.system, whole.map);
  const SignalView input = whole.input_of(whole.map);
  const std::size_t answer = model.answer->labels.classify(som, input, workspace);
  ASSERT_FALSE(reading.candidates.empty());
  EXPECT_EQ(reading.candidates.front().number, answer);
}

void expect_says_what_evaluating_says(const std::string& text, std::size_t maps) {
  SCOPED_TRACE(text);
  Recording recording = testing::hand_recording(6, 3);
  auto model = testing::trained_model(text, recording);
  auto reader = SystemReading::build(model).value();
  std::size_t read = 0;
  for (const Exploration& exploration : recording.explorations) {
    const Timeline timeline(exploration);
    reader.start();
    for (std::size_t moment = 0; moment < timeline.moments(); ++moment) {
      const std::vector<std::size_t> come = frames_at(timeline, exploration, moment);
      ASSERT_TRUE(reader.follow(exploration, come));
      const auto reading = reader.read();
      if (!reading || !*reading) continue;
      ++read;
      EXPECT_EQ((*reading)->maps.size(), maps);
      Whole whole{model->system, {{cut_at(exploration, come)}}, reader.map()};
      expect_as_whole(**reading, *model, whole);
    }
  }
  EXPECT_GE(read, 2 * recording.explorations.size());
}

TEST(SystemReading, SaysWhatEvaluatingTheExplorationSoFarSays) {
  expect_says_what_evaluating_says(testing::crossed_system(), 1);
  expect_says_what_evaluating_says(testing::two_maps_system(), 2);
  expect_says_what_evaluating_says(testing::sound_system(), 1);
}

TEST(SystemReading, ShowsEveryModule) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reader =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  EXPECT_FALSE(reader.is_costly());
  reader.start();
  ASSERT_TRUE(reader.follow(recording.explorations[0], {2, 2, 2, 2, 0}));
  const Reading reading = **reader.read();
  // Two channels, code, product, memory and unit; the map is among the maps.
  EXPECT_EQ(reading.modules.size(), 6U);
  EXPECT_EQ(reading.maps.size(), 1U);
}

TEST(SystemReading, IsCostlyWhereExplorationsAreNeededAsAWhole) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reader =
      SystemReading::build(testing::trained_model(testing::sound_system(), recording)).value();
  EXPECT_TRUE(reader.is_costly());
}

// A value that the sensor did not give is taken as evaluating takes it: held here.
TEST(SystemReading, FollowsAnExplorationWithGaps) {
  Recording recording = testing::hand_recording(6, 3);
  std::string text = testing::crossed_system();
  const std::string touch = "channel = \"touch\"";
  ASSERT_NE(text.find(touch), std::string::npos) << text;
  text.insert(text.find(touch) + touch.size(), "\ninvalid = \"hold\"");
  auto model = testing::trained_model(text, recording);
  for (Channel& channel : recording.explorations[0].channels) {
    if (channel.name != "touch") continue;
    channel.valid = Matrix<std::uint8_t>(channel.frames.rows(), channel.frames.columns(), 1);
    channel.valid(1, 2) = 0;
    channel.frames(1, 2) = 0.0F;
  }
  auto reader = SystemReading::build(model).value();
  ASSERT_TRUE(reader.follow(recording.explorations[0], {2, 2, 2, 2, 2}));
  const auto reading = reader.read();
  ASSERT_TRUE(reading && *reading);
  Whole whole{model->system, {{recording.explorations[0]}}, reader.map()};
  for (Channel& channel : whole.recording.explorations[0].channels) {
    const auto kept = channel.frames.values().first(2 * channel.frames.columns());
    channel.frames = Matrix<float>(2, channel.frames.columns(), {kept.begin(), kept.end()});
    if (channel.valid.empty()) continue;
    const auto valid = channel.valid.values().first(2 * channel.valid.columns());
    channel.valid = Matrix<std::uint8_t>(2, channel.valid.columns(), {valid.begin(), valid.end()});
  }
  expect_as_whole(**reading, *model, whole);
}

TEST(SystemReading, SaysNothingBeforeThereWasAFrame) {
  const Recording recording = testing::hand_recording(6, 3);
  auto reader =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  reader.start();
  ASSERT_TRUE(reader.follow(recording.explorations[0], {0, 0, 0, 0, 0}));
  EXPECT_FALSE(*reader.read());
}

TEST(SystemReading, RefusesWhatDoesNotFit) {
  Recording recording = testing::hand_recording(6, 3);
  auto reader =
      SystemReading::build(testing::trained_model(testing::crossed_system(), recording)).value();
  Exploration other = recording.explorations[0];
  other.channels[2].name = "elbows";
  reader.start();
  EXPECT_FALSE(reader.follow(other, {1, 1, 1, 1, 1}));
  other = recording.explorations[0];
  other.channels[2].frames = Matrix<float>(2, 5);
  reader.start();
  EXPECT_FALSE(reader.follow(other, {1, 1, 1, 1, 1}));
  EXPECT_FALSE(SystemReading::build(std::make_shared<SystemModel>()));
}

TEST(Reading, IsSureWhenTheNextClassIsFar) {
  Reading reading;
  EXPECT_EQ(reading.confidence(), 0.0);
  reading.candidates = {{0, 1.0}};
  EXPECT_EQ(reading.confidence(), 1.0);
  reading.candidates = {{0, 1.0}, {1, 4.0}};
  EXPECT_EQ(reading.confidence(), 0.75);
  reading.candidates = {{0, 2.0}, {1, 2.0}};
  EXPECT_EQ(reading.confidence(), 0.0);
}

TEST(Reading, IsUnknownAboveTheThresholdOnly) {
  Reading reading;
  reading.candidates = {{1, 1.0}, {0, 2.0}};
  EXPECT_EQ(reading.name({"ball", "cube"}), "cube");
  reading.novelty = 1.0;
  EXPECT_EQ(reading.name({"ball", "cube"}), "cube");
  reading.novelty = 1.01;
  EXPECT_EQ(reading.name({"ball", "cube"}), "unknown");
}

}  // namespace
}  // namespace somato::live

#include "systems/walk/walk.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::dense;
using testing::hand_recording;
using testing::module;
using testing::output_of;

std::vector<float> values_of(const std::optional<SignalView>& view) {
  std::vector<float> values(view.value().size);
  write_dense(*view, values);
  return values;
}

TEST(Walk, GivesWhatAModuleGaveForTheLatestFrame) {
  const Recording recording = hand_recording(1, 3);
  const Exploration& exploration = recording.explorations[0];
  const System system =
      build(channels({"joints"}) + module("twice", "scale", "input = 'joints'\nfactor = 2") +
                module("stm", "accumulate", "input = 'twice'"),
            recording);
  const std::size_t twice = *system.find("twice");
  const std::size_t stm = *system.find("stm");
  Walk walk(system, {stm}, Outputs::kLatest);
  ASSERT_TRUE(walk.start(&exploration));
  EXPECT_FALSE(walk.has_frames());
  EXPECT_FALSE(walk.output(twice));
  const Matrix<float>& joints = testing::frames_of(recording, "joints", 0);
  std::vector<float> sum(3);
  for (std::size_t frame = 0; frame < joints.rows(); ++frame) {
    ASSERT_TRUE(walk.step(frame));
    EXPECT_FALSE(walk.output(stm));  // before settle()
    ASSERT_TRUE(walk.settle());
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(values_of(walk.output(twice))[i], 2.0F * joints(frame, i));
      sum[i] += 2.0F * joints(frame, i);
      EXPECT_NEAR(values_of(walk.output(stm))[i], sum[i], 1e-6);
    }
  }
  EXPECT_FALSE(walk.is_costly());
}

// The frames of the hand and those of the microphone come at their own times.
TEST(Walk, FollowsEachClockAsFarAsItsChannelsHaveCome) {
  const Recording recording = hand_recording(1, 3);
  const System system = build(channels({"height", "joints", "sound"}) +
                                  module("hand", "concatenation", "inputs = ['height', 'joints']"),
                              recording);
  EXPECT_EQ(Walk(system, {0, 1, 2, 3}, Outputs::kLatest).channels(),
            (std::vector<std::vector<std::string>>{{"height", "joints"}, {"sound"}}));
  Walk walk(system, {0, 1, 2, 3}, Outputs::kLatest);
  ASSERT_TRUE(walk.start(&recording.explorations[0]));
  ASSERT_TRUE(walk.follow(std::vector<std::size_t>{2, 0, 1, 0, 5}));
  const Matrix<float>& sound = testing::frames_of(recording, "sound", 0);
  EXPECT_EQ(values_of(walk.output(*system.find("sound"))), std::vector<float>{sound(4, 0)});
  const Matrix<float>& height = testing::frames_of(recording, "height", 0);
  EXPECT_EQ(values_of(walk.output(*system.find("hand")))[0], height(0, 0));  // joints have one
  EXPECT_TRUE(walk.has_frames());
}

// A module on whole explorations, frames that it gives, and a memory and a loop over these.
TEST(Walk, RunsWhatNeedsWholeExplorationsAgainEachTimeItSettles) {
  const Recording recording = hand_recording(2, 3);
  const System system =
      build(channels({"sound"}) + module("level", "mean_removal", "input = 'sound'") +
                module("mixed", "sum", "inputs = ['level', 'late']") +
                module("late", "delay", "input = 'mixed'\nshape = [1]") +
                module("stm", "accumulate", "input = 'mixed'") +
                module("unit", "normalization", "input = 'stm'\nnorm = 'l1'"),
            recording);
  const std::size_t unit = *system.find("unit");
  Walk walk(system, {unit}, Outputs::kLatest);
  EXPECT_TRUE(walk.is_costly());
  Exploration so_far = recording.explorations[1];
  const Matrix<float> sound = so_far.channels[4].frames;
  so_far.channels[4].frames = Matrix<float>(0, 1);
  ASSERT_TRUE(walk.start(&so_far));
  for (std::size_t frame = 0; frame < sound.rows(); ++frame) {
    so_far.channels[4].frames.add_row()[0] = sound(frame, 0);
    ASSERT_TRUE(walk.follow(std::vector<std::size_t>{0, 0, 0, 0, frame + 1}));
    ASSERT_TRUE(walk.settle());
    Recording cut;
    cut.explorations.push_back(so_far);
    EXPECT_EQ(Matrix<float>(1, 1, values_of(walk.output(unit))),
              dense(output_of(system, cut, "unit", 0)));
  }
}

// Frames that were followed need not stay in memory.
TEST(Walk, FollowsAnExplorationWhoseFirstFramesAreDropped) {
  const Recording recording = hand_recording(1, 3);
  const System system =
      build(channels({"joints"}) + module("stm", "accumulate", "input = 'joints'"), recording);
  const std::size_t stm = *system.find("stm");
  Walk whole(system, {stm}, Outputs::kLatest);
  ASSERT_TRUE(whole.start(&recording.explorations[0]));
  ASSERT_TRUE(whole.run());
  Exploration left = recording.explorations[0];
  Walk walk(system, {stm}, Outputs::kLatest);
  ASSERT_TRUE(walk.start(&left));
  const Matrix<float> joints = left.channels[2].frames;
  for (std::size_t frame = 0; frame < joints.rows(); ++frame) {
    const auto row = joints.row(frame);
    left.channels[2].frames = Matrix<float>(1, 3, std::vector<float>(row.begin(), row.end()));
    ASSERT_TRUE(walk.follow(std::vector<std::size_t>{0, 0, frame + 1, 0, 0},
                            std::vector<std::size_t>{0, 0, frame, 0, 0}));
  }
  ASSERT_TRUE(walk.settle());
  EXPECT_EQ(values_of(walk.output(stm)), values_of(whole.output(stm)));
}

// A channel of one float a frame, of which a module needs all: 40 bytes are ten frames.
TEST(Walk, AnErrorNamesTheModuleWhoseFramesTakeTooMuchMemory) {
  const Recording recording = hand_recording(1, 3);
  const System system =
      build(channels({"sound"}) + module("level", "mean_removal", "input = 'sound'"), recording);
  Walk walk(system, {*system.find("level")}, Outputs::kLatest);
  walk.limit_memory(40);
  for (int again = 0; again < 2; ++again) {
    ASSERT_TRUE(walk.start(&recording.explorations[0]));
    for (std::size_t frames = 1; frames <= 10; ++frames) {
      ASSERT_TRUE(walk.follow(std::vector<std::size_t>{0, 0, 0, 0, frames}));
      ASSERT_TRUE(walk.settle());
    }
    const auto followed = walk.follow(std::vector<std::size_t>{0, 0, 0, 0, 11});
    ASSERT_FALSE(followed);
    EXPECT_NE(followed.error().where.find("module 'sound'"), std::string::npos);
    EXPECT_NE(followed.error().what.find("40 B"), std::string::npos) << followed.error().what;
  }
}

TEST(Walk, HoldsValuesThatAreNotValidAsEvaluatingDoes) {
  Recording recording = hand_recording(1, 7);
  Channel& height = recording.explorations[0].channels[0];
  height.frames = Matrix<float>(4, 1, {0, 5, 0, 0});
  height.valid = Matrix<std::uint8_t>(4, 1, {0, 1, 0, 0});
  const System system =
      build(module("m", "channel", "channel = 'height'\ninvalid = 'hold'"), recording);
  Walk walk(system, {0}, Outputs::kAll);
  for (int again = 0; again < 2; ++again) {  // nothing is left from the exploration before
    ASSERT_TRUE(walk.start(&recording.explorations[0]));
    ASSERT_TRUE(walk.run());
    EXPECT_EQ(dense(walk.take(0)), Matrix<float>(4, 1, {0, 5, 5, 5}));
  }
}

TEST(Walk, NamesTheChannelThatIsMissing) {
  const Recording recording = hand_recording(1, 3);
  const System system = build(channels({"joints"}), recording);
  Exploration other = recording.explorations[0];
  other.channels[2].name = "joint";
  Walk walk(system, {0}, Outputs::kLatest);
  const auto started = walk.start(&other);
  ASSERT_FALSE(started);
  EXPECT_NE(to_string(started.error()).find("did you mean 'joint'?"), std::string::npos);
}

}  // namespace
}  // namespace somato
